// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/link_receiver.h"

#include <QCryptographicHash>
#include <QLocalServer>
#include <QLocalSocket>
#include <QStandardPaths>

namespace mocapress {
namespace {

constexpr int kPatienceMs = 1000;
constexpr qint64 kLongestLink = 1 << 16;  // bytes

}  // namespace

/// The address depends on the folder with the user's projects: studios with different folders do
/// not pass links to each other.
QString LinkReceiver::ownAddress() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  const QByteArray hash = QCryptographicHash::hash(data.toUtf8(), QCryptographicHash::Sha1);
  return QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation) +
         QStringLiteral("/mocapress-") + QString::fromLatin1(hash.toHex().left(12));
}

LinkReceiver::LinkReceiver(QObject* parent, const QString& address)
    : QObject(parent), server_(new QLocalServer(this)) {
  server_->setSocketOptions(QLocalServer::UserAccessOption);
  connect(server_, &QLocalServer::newConnection, this, &LinkReceiver::receive);
  QLocalSocket other;
  other.connectToServer(address);
  if (other.waitForConnected(kPatienceMs)) return;  // another studio receives the links
  QLocalServer::removeServer(address);              // left by a studio that was killed
  server_->listen(address);
}

void LinkReceiver::receive() {
  while (QLocalSocket* sender = server_->nextPendingConnection()) {
    const auto take = [this, sender] {
      const QString link = QString::fromUtf8(sender->read(kLongestLink));
      sender->deleteLater();
      if (!link.isEmpty()) emit received(link);
    };
    if (sender->state() == QLocalSocket::UnconnectedState)
      take();
    else
      connect(sender, &QLocalSocket::disconnected, this, take);
  }
}

bool handOver(const QString& link, const QString& address) {
  QLocalSocket studio;
  studio.connectToServer(address);
  if (!studio.waitForConnected(kPatienceMs)) return false;
  studio.write(link.toUtf8());
  const bool is_written = studio.waitForBytesWritten(kPatienceMs);
  studio.disconnectFromServer();
  return is_written;
}

}  // namespace mocapress

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

class QLocalServer;

namespace mocapress {

/// Receives the links (mocapress://) for which the program is started while a studio runs already:
/// the clip is in that studio's project, with its settings and verdict. Only the first studio of a
/// user receives links.
class LinkReceiver : public QObject {
  Q_OBJECT

 public:
  explicit LinkReceiver(QObject* parent = nullptr, const QString& address = ownAddress());

  /// The address at which this user's studio listens.
  static QString ownAddress();

 signals:
  void received(const QString& link);

 private:
  void receive();

  QLocalServer* server_;
};

/// Passes the link on to the studio that runs. False: there is none.
bool handOver(const QString& link, const QString& address = LinkReceiver::ownAddress());

}  // namespace mocapress

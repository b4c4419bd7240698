// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/help.h"

#include <QAction>
#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "app/studio/window/commands.h"

namespace mocapress {
namespace {

struct HelpTexts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Help)
};

constexpr QSize kSize(820, 720);

QString rowsOf(const QMenu& menu) {
  QString rows;
  for (const QAction* action : menu.actions()) {
    if (action->menu()) rows += rowsOf(*action->menu());
    if (action->shortcut().isEmpty()) continue;
    rows += QStringLiteral("<tr><td>%1</td><td>&nbsp;&nbsp;<b>%2</b></td></tr>")
                .arg(nameOf(*action).toHtmlEscaped(),
                     action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped());
  }
  return rows;
}

}  // namespace

QString shortcutSheet(const QMenuBar& menus) {
  QString html;
  for (const QAction* top : menus.actions()) {
    const QString rows = rowsOf(*top->menu());
    if (!rows.isEmpty())
      html += QStringLiteral("<h3>%1</h3><table cellpadding='3'>%2</table>")
                  .arg(plainText(top->text()), rows);
  }
  const QStringList mouse = {
      HelpTexts::tr("Left drag in the 3D view: turn; in a view along an axis: move"),
      HelpTexts::tr("Right or middle drag: move"),
      HelpTexts::tr("Wheel: nearer or further"),
      HelpTexts::tr("Click on a joint: select it"),
      HelpTexts::tr("Wheel over the timeline: zoom; with Shift: move along"),
      HelpTexts::tr("Click on the scale of the error strip: choose another"),
      HelpTexts::tr("Drag an end of a contact: move it; right button: add or remove"),
      HelpTexts::tr("Drag on the ruler: choose a range; right button: what to do with it"),
      HelpTexts::tr("Shift and drag on the error strip: choose the range that is played")};
  html += QStringLiteral("<h3>%1</h3><ul><li>%2</li></ul>")
              .arg(HelpTexts::tr("Mouse"), mouse.join(QStringLiteral("</li><li>")));
  return html;
}

QString guideHtml() {
  const QString language = QLocale().name().left(2);
  for (const QString& one : {language, QStringLiteral("en")}) {
    QFile file(QStringLiteral(":/guide/guide_%1.html").arg(one));
    if (file.open(QIODevice::ReadOnly)) return QString::fromUtf8(file.readAll());
  }
  return {};
}

HelpWindow::HelpWindow(const QString& title, const QString& html, QWidget* parent)
    : QDialog(parent) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(title);
  resize(kSize);
  auto* page = new QTextBrowser(this);
  page->setAccessibleName(title);
  page->setOpenExternalLinks(true);
  page->setFrameShape(QFrame::NoFrame);
  page->document()->setDocumentMargin(20);
  page->setHtml(html);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(page);
}

void showGuide(QWidget* window) {
  (new HelpWindow(HelpTexts::tr("Guide"), guideHtml(), window))->show();
}

void showShortcuts(const QMenuBar& menus, QWidget* window) {
  (new HelpWindow(HelpTexts::tr("Keyboard Shortcuts"), shortcutSheet(menus), window))->show();
}

void showAbout(QWidget* window) {
  QMessageBox::about(
      window, HelpTexts::tr("About Mocapress"),
      HelpTexts::tr(
          "<h3>Mocapress %1</h3>"
          "<p>Compresses human motion capture clips with wavelets, after Philippe Beaudoin, Pierre "
          "Poulin and Michiel van de Panne, <i>Adapting Wavelet Compression to Human Motion "
          "Capture "
          "Clips</i>, Graphics Interface 2007.</p>"
          "<p>The studio is free software under the GNU General Public License, version 3 or "
          "later; "
          "the compression library is under the MIT licence.</p>")
          .arg(QCoreApplication::applicationVersion()));
}

}  // namespace mocapress

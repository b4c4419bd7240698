// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/theme.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QPainter>
#include <QSettings>
#include <QStyleFactory>
#include <QStyleOption>
#include <QToolTip>

namespace mocapress {

StudioStyle::StudioStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void StudioStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  if (element == PE_PanelButtonTool && option->state & State_On) {
    // Fusion's own checked button hardly differs from others on dark ground.
    QColor colour = option->palette.color(QPalette::Highlight);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(colour, 1.5));
    colour.setAlphaF(0.25F);
    painter->setBrush(colour);
    painter->drawRoundedRect(QRectF(option->rect).adjusted(1, 1, -1, -1), 2, 2);
    painter->restore();
  }
  if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) return;
  QColor outline = option->palette.color(QPalette::Text);
  outline.setAlphaF(option->state & State_Enabled ? 0.5F : 0.25F);
  painter->save();
  painter->setPen(outline);
  painter->setBrush(Qt::NoBrush);
  painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
  painter->restore();
}

void StudioStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                     QPainter* painter, const QWidget* widget) const {
  constexpr double kDisabled = 0.35;  // opacity of a disabled slider
  painter->save();
  if (control == CC_Slider && !(option->state & State_Enabled)) painter->setOpacity(kDisabled);
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  painter->restore();
}

int StudioStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* returned) const {
  if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton;
  return QProxyStyle::styleHint(hint, option, widget, returned);
}

namespace {

const QString kThemeSetting = QStringLiteral("window/theme");
const QString kService = QStringLiteral("org.freedesktop.portal.Desktop");
const QString kObject = QStringLiteral("/org/freedesktop/portal/desktop");
const QString kInterface = QStringLiteral("org.freedesktop.portal.Settings");
const QString kGroup = QStringLiteral("org.freedesktop.appearance");
const QString kKey = QStringLiteral("color-scheme");
constexpr uint kPrefersDark = 1;  // the portal's value for dark

struct Colours {
  QRgb window, base, alternate, text, faint, button, highlight, link, tip;
};

QPalette paletteOf(const Colours& colours) {
  QPalette palette;
  const auto set = [&](std::initializer_list<QPalette::ColorRole> roles, QRgb colour) {
    for (const auto role : roles) palette.setColor(role, QColor(colour));
  };
  set({QPalette::Window}, colours.window);
  set({QPalette::Base}, colours.base);
  set({QPalette::AlternateBase}, colours.alternate);
  set({QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText},
      colours.text);
  set({QPalette::PlaceholderText}, colours.faint);
  set({QPalette::Button}, colours.button);
  set({QPalette::ToolTipBase}, colours.tip);
  set({QPalette::Highlight}, colours.highlight);
  set({QPalette::HighlightedText, QPalette::BrightText}, 0xffffffff);
  set({QPalette::Link, QPalette::LinkVisited}, colours.link);
  const QColor button(colours.button);
  palette.setColor(QPalette::Light, button.lighter(130));
  palette.setColor(QPalette::Midlight, button.lighter(112));
  palette.setColor(QPalette::Mid, button.darker(125));
  palette.setColor(QPalette::Dark, button.darker(150));
  palette.setColor(QPalette::Shadow, button.darker(210));
  QColor disabled(colours.text);
  disabled.setAlphaF(0.42F);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, disabled);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(colours.faint));
  return palette;
}

}  // namespace

QPalette lightPalette() {
  return paletteOf({.window = 0xffefefef,
                    .base = 0xffffffff,
                    .alternate = 0xfff6f6f6,
                    .text = 0xff16191c,
                    .faint = 0xff62676d,
                    .button = 0xffefefef,
                    .highlight = 0xff2a7ab8,
                    .link = 0xff1f5f99,
                    .tip = 0xffffffff});
}

QPalette darkPalette() {
  return paletteOf({.window = 0xff2b2e32,
                    .base = 0xff1f2124,
                    .alternate = 0xff26292d,
                    .text = 0xffe6e8ea,
                    .faint = 0xff9aa0a6,
                    .button = 0xff363a3f,
                    .highlight = 0xff3a86c2,
                    .link = 0xff7fb8ea,
                    .tip = 0xff3a3e43});
}

Theme::Theme(QObject* parent)
    : QObject(parent),
      choice_(static_cast<ThemeChoice>(QSettings().value(kThemeSetting, 0).toInt())),
      system_dark_(QApplication::palette().color(QPalette::Window).lightnessF() < 0.5F) {
  askDesktop();
  apply();
}

void Theme::choose(ThemeChoice choice) {
  choice_ = choice;
  QSettings().setValue(kThemeSetting, static_cast<int>(choice));
  apply();
}

void Theme::setSystemDark(bool dark) {
  system_dark_ = dark;
  apply();
}

/// Asks the desktop's settings portal. Without a portal, Qt's own palette has decided.
void Theme::askDesktop() {
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return;
  bus.connect(kService, kObject, kInterface, QStringLiteral("SettingChanged"), this,
              SLOT(desktopChanged(QString, QString, QDBusVariant)));
  QDBusMessage question =
      QDBusMessage::createMethodCall(kService, kObject, kInterface, QStringLiteral("Read"));
  question << kGroup << kKey;
  auto* waiting = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
  connect(waiting, &QDBusPendingCallWatcher::finished, this, [this, waiting] {
    const QDBusPendingReply<QDBusVariant> reply = *waiting;
    if (!reply.isError()) desktopChanged(kGroup, kKey, reply.value());
    waiting->deleteLater();
  });
}

void Theme::desktopChanged(const QString& group, const QString& key, const QDBusVariant& value) {
  if (group != kGroup || key != kKey) return;
  QVariant scheme = value.variant();
  // Older portals wrap the value twice.
  if (scheme.canConvert<QDBusVariant>()) scheme = scheme.value<QDBusVariant>().variant();
  setSystemDark(scheme.toUInt() == kPrefersDark);
}

void Theme::apply() {
  const bool dark =
      choice_ == ThemeChoice::Dark || (choice_ == ThemeChoice::System && system_dark_);
  const QPalette palette = dark ? darkPalette() : lightPalette();
  QApplication::setPalette(palette);
  QToolTip::setPalette(palette);
}

}  // namespace mocapress

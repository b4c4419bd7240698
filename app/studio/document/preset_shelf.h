// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

#include "core/mocapress/settings.h"

class QUndoStack;

namespace mocapress {

/// The presets there are: built-in ones and the user's own, which are kept in a file that the
/// command line takes too.
class PresetShelf : public QObject {
  Q_OBJECT

 public:
  /// A file that cannot be read is kept under another name once there is something to write.
  explicit PresetShelf(const QString& file, QObject* parent = nullptr);

  /// In the folder of the settings.
  static QString usualFile();

  /// Built-in ones first.
  std::vector<Settings> all() const;

  /// Where changes go that the user can undo; unset: they cannot.
  void setHistory(std::function<QUndoStack*()> history) { history_ = std::move(history); }

  /// Whether a preset of the user's may have this name; if not, noted().
  bool isFree(const std::string& name);
  static bool isBuiltIn(const std::string& name);

  /// Takes the place of an own one of that name. False, and noted(): a built-in one has that name.
  bool save(const Settings& preset);
  bool rename(const QString& name, const QString& to);
  void remove(const QString& name);
  void importFrom(const QString& path);
  void exportTo(const QString& path, const Settings& preset);

 signals:
  void changed();

  /// Worth telling, and no more than that.
  void noted(const QString& message);

 private:
  /// What becomes of one preset; either may be unset.
  struct Edit {
    std::optional<Settings> before, after;
  };

  const Settings* own(const std::string& name) const;
  void change(const QString& text, const std::vector<Edit>& edits);
  void apply(const std::vector<Edit>& edits, bool backwards);
  bool setAside();
  void write();

  QString file_;
  bool unreadable_ = false;  // what is in the file
  std::vector<Settings> own_;
  std::function<QUndoStack*()> history_;
};

}  // namespace mocapress

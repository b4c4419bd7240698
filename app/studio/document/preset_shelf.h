// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <vector>

#include "core/mocapress/settings.h"

class QUndoStack;

namespace mocapress {

/// All presets: built-in ones and the user's own, kept in a file that the command line reads too.
class PresetShelf : public QObject {
  Q_OBJECT

 public:
  /// An unreadable file is renamed before the first write.
  explicit PresetShelf(const QString& file, QObject* parent = nullptr);

  /// The file in the settings folder.
  static QString usualFile();

  /// All presets, built-in ones first.
  std::vector<Settings> all() const;

  /// Sets a function that returns the undo history for changes. Without it they cannot be undone.
  void setHistory(std::function<QUndoStack*()> history) { history_ = std::move(history); }

  /// True if one of the user's presets may have this name; otherwise emits noted().
  bool isFree(const std::string& name);
  static bool isBuiltIn(const std::string& name);

  /// Saves a preset in place of the user's own of that name. Returns false and emits noted() if a
  /// built-in preset has that name.
  bool save(const Settings& preset);
  bool rename(const QString& name, const QString& to);
  void remove(const QString& name);
  void importFrom(const QString& path);
  void exportTo(const QString& path, const Settings& preset);

 signals:
  void changed();

  /// A message for the user that needs no answer.
  void noted(const QString& message);

 private:
  /// A preset before and after a change; unset: absent.
  struct Edit {
    std::optional<Settings> before, after;
  };

  const Settings* own(const std::string& name) const;
  void change(const std::function<QString()>& name, const std::vector<Edit>& edits);
  void apply(const std::vector<Edit>& edits, bool backwards);
  bool setAside();
  void write();

  QString file_;
  bool unreadable_ = false;  // the file could not be read
  std::vector<Settings> own_;
  std::function<QUndoStack*()> history_;
};

}  // namespace mocapress

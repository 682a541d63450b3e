#pragma once

#include <QString>

#include "core/base/Result.h"

namespace vestige {

class ActionCatalog;

/// Every shortcut as the user has it, by menu, with what the mouse does: a page to print.
QString shortcutSheetHtml(const ActionCatalog& actions);
/// The same as plain text.
QString shortcutSheetText(const ActionCatalog& actions);

/// Writes the sheet as the file's name says: .pdf, .html or .txt. ErrorCode::usage for another name,
/// ErrorCode::output where it cannot be written.
Status writeShortcutSheet(const ActionCatalog& actions, const QString& file);

}  // namespace vestige

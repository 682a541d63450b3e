#pragma once

#include <QString>

namespace vestige {

/// An action's text as a button or a list has it: "&Open case…" and "打开案件(&O)…" without mnemonic and
/// dots.
QString withoutMnemonic(const QString& text);

}  // namespace vestige

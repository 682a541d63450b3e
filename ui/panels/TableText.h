#pragma once

#include <QString>

class QAbstractItemView;

namespace vestige {

/// A list or table as text for a spreadsheet: cells parted by tabs, the headings with their units first where
/// the view shows any, numbers with '-' and '.', nothing for what is not there. The selected rows, or all of
/// them: where `all`, and where none is selected.
QString tableText(const QAbstractItemView& view, bool all);

}  // namespace vestige

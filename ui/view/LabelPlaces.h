#pragma once

#include <QLineF>
#include <QRectF>
#include <QSizeF>
#include <optional>
#include <vector>

namespace vestige {

/// A label that wants a place in the picture, pixels.
struct LabelWish {
    QLineF line;            ///< what it tells of
    QSizeF size;            ///< beside its line
    QSizeF sizeAside;       ///< in a column, where it also says its name
    QSizeF sizeBrief = {};  ///< with the value alone, for small pictures
    bool must = false;      ///< rather over something else than not at all
    bool still = false;     ///< stays at its line: it is being drawn
};

struct LabelPlace {
    QRectF box;
    std::optional<QLineF> leader;  ///< from a label that stands aside to the middle of its line
    bool brief = false;            ///< room for the value alone
};

/// A place for each label, in the order of the wishes; earlier ones choose first. A label stands beside its
/// line where that is longer than the label and there is room; the others stand in two columns left and right
/// of all lines, in the order of what they tell of, with leaders that do not cross within a column. In a
/// picture too small for columns only those stand there that must have a place; of the others the value alone
/// stands near its line. No label covers another or `taken`; one for which there is no room has no place,
/// unless it must. A function of its arguments alone.
std::vector<std::optional<LabelPlace>> placeLabels(const std::vector<LabelWish>& wishes,
                                                   const QRectF& picture, std::vector<QRectF> taken);

}  // namespace vestige

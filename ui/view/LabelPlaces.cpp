#include "ui/view/LabelPlaces.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace vestige {
namespace {

constexpr double kEdge_px = 4;     ///< a label keeps off the picture's edge
constexpr double kBetween_px = 5;  ///< from one label of a column to the next
constexpr double kBeside_px = 46;  ///< from the outermost line to a column
/// Columns of labels would take most of a picture narrower or lower than this.
constexpr double kNarrow_px = 640;
constexpr double kLow_px = 400;

/// Where a label can stand beside the line: at the middle first, then along it, further off.
std::vector<QRectF> placesBeside(const QLineF& line, const QSizeF& size, bool anywhere) {
    const QPointF along = line.p2() - line.p1();
    const double length = line.length();
    QPointF aside = length > 1 ? QPointF(-along.y(), along.x()) / length : QPointF(0, -1);
    if (aside.y() > 0 || (aside.y() == 0 && aside.x() < 0)) aside = -aside;
    const double reach = 0.5 * (std::abs(aside.x()) * size.width() + std::abs(aside.y()) * size.height()) + 9;
    std::vector<QRectF> places;
    for (const double distance : {0.0, 16.0, 34.0, 60.0, 95.0, 140.0}) {
        if (!anywhere && distance > 16) break;
        for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.0, 1.0})
            for (const double side : {1.0, -1.0}) {
                const QPointF centre = line.p1() + share * along + side * (reach + distance) * aside;
                places.emplace_back(centre - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
            }
    }
    return places;
}

double overlapArea(const QRectF& place, const std::vector<QRectF>& taken) {
    double area = 0;
    for (const QRectF& other : taken) {
        const QRectF common = place.adjusted(-3, -3, 3, 3) & other;
        if (!common.isEmpty()) area += common.width() * common.height();
    }
    return area;
}

/// The first place that is free and inside; with `must` the least bad one.
std::optional<QRectF> choose(const std::vector<QRectF>& places, const QRectF& inside,
                             const std::vector<QRectF>& taken, bool must) {
    std::optional<QRectF> best;
    double least = 0;
    for (const QRectF& place : places) {
        if (!inside.contains(place)) continue;
        const double overlap = overlapArea(place, taken);
        if (overlap == 0) return place;
        if (must && (!best || overlap < least)) {
            best = place;
            least = overlap;
        }
    }
    return best;
}

/// A part of a column that nothing stands in.
struct Stretch {
    double from;
    double to;
    std::size_t holds(double pitch) const {
        return static_cast<std::size_t>(std::max(0.0, (to - from + kBetween_px) / pitch));
    }
};

/// From top to bottom.
std::vector<Stretch> freeStretches(const QRectF& column, const std::vector<QRectF>& taken) {
    std::vector<std::pair<double, double>> blocked;
    for (const QRectF& other : taken)
        if (other.intersects(column))
            blocked.emplace_back(other.top() - kBetween_px, other.bottom() + kBetween_px);
    std::sort(blocked.begin(), blocked.end());
    blocked.emplace_back(column.bottom(), column.bottom());
    std::vector<Stretch> free;
    double from = column.top();
    for (const auto& [top, bottom] : blocked) {
        if (top > from) free.push_back({from, top});
        from = std::max(from, bottom);
    }
    return free;
}

/// How many of the labels, sorted by where they want to be, go into each stretch: each to the nearest one
/// that leaves room for those after it.
std::vector<std::size_t> shared(const std::vector<double>& wished, const std::vector<Stretch>& stretches,
                                double pitch) {
    std::vector<std::size_t> counts(stretches.size());
    std::size_t later = 0;
    for (const Stretch& stretch : stretches) later += stretch.holds(pitch);
    std::size_t next = 0;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
        const std::size_t room = stretches[k].holds(pitch);
        later -= room;
        while (next < wished.size() && counts[k] < room) {
            const auto away = [&](const Stretch& stretch) {
                return std::max({0.0, stretch.from - wished[next], wished[next] + pitch - stretch.to});
            };
            const bool nearerLater =
                std::any_of(stretches.begin() + static_cast<std::ptrdiff_t>(k) + 1, stretches.end(),
                            [&](const Stretch& other) {
                                return other.holds(pitch) > 0 && away(other) < away(stretches[k]);
                            });
            if (nearerLater && wished.size() - next <= later) break;
            ++counts[k];
            ++next;
        }
    }
    return counts;
}

/// Tops of labels one below the other, as near to the wished ones (ascending) as can be, within the stretch:
/// neighbours that would overlap make a block, which stands where its labels want to be on average.
std::vector<double> stacked(const std::vector<double>& wished, double pitch, double from, double to) {
    struct Block {
        double sum = 0;  ///< of wished top less its offset in the block
        std::size_t count = 0;
        double top = 0;
    };
    std::vector<Block> blocks;
    const auto place = [&](Block& block) {
        const double room = to - pitch * static_cast<double>(block.count);
        block.top = std::max(from, std::min(block.sum / static_cast<double>(block.count), room));
    };
    for (const double top : wished) {
        blocks.push_back({top, 1, 0});
        place(blocks.back());
        while (blocks.size() > 1) {
            Block& before = blocks[blocks.size() - 2];
            const Block& last = blocks.back();
            const double height = pitch * static_cast<double>(before.count);
            if (before.top + height <= last.top) break;
            before.sum += last.sum - height * static_cast<double>(last.count);
            before.count += last.count;
            blocks.pop_back();
            place(before);
        }
    }
    std::vector<double> tops;
    for (const Block& block : blocks)
        for (std::size_t i = 0; i < block.count; ++i)
            tops.push_back(block.top + pitch * static_cast<double>(i));
    return tops;
}

/// Small boxes along a line and round its ends, which labels beside lines leave free.
void addLine(const QLineF& line, std::vector<QRectF>& taken) {
    for (const QPointF& end : {line.p1(), line.p2()}) taken.emplace_back(end - QPointF(6, 6), QSizeF(12, 12));
    const int count = static_cast<int>(line.length() / 10);
    for (int i = 1; i < count; ++i)
        taken.emplace_back(line.pointAt(static_cast<double>(i) / count) - QPointF(2, 2), QSizeF(4, 4));
}

bool cross(const QLineF& one, const QLineF& other) {
    return one.intersects(other, nullptr) == QLineF::BoundedIntersection;
}

/// Two columns of labels with leaders.
class Columns {
  public:
    Columns(const std::vector<LabelWish>& wishes, const QRectF& inside, std::vector<QRectF> taken)
        : wishes_(wishes), inside_(inside), taken_(std::move(taken)) {
        QRectF lines;
        for (const LabelWish& wish : wishes_)
            lines |= QRectF(wish.line.p1(), wish.line.p2()).normalized().adjusted(-1, -1, 1, 1);
        left_ = lines.left() - kBeside_px;
        right_ = lines.right() + kBeside_px;
    }

    void place(std::vector<std::size_t> open, std::vector<std::optional<LabelPlace>>& places) {
        std::sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) {
            const QPointF one = middle(a);
            const QPointF other = middle(b);
            return std::tuple(one.x(), one.y(), a) < std::tuple(other.x(), other.y(), b);
        });
        auto half = static_cast<std::ptrdiff_t>(open.size() / 2);
        // A single one stands on the side with more room.
        if (open.size() == 1 && left_ - inside_.left() > inside_.right() - right_) half = 1;
        fill({open.begin(), open.begin() + half}, true, places);
        // In a narrow picture the other column may reach over this one.
        for (auto one = open.begin(); one != open.begin() + half; ++one)
            if (places[*one]) taken_.push_back(places[*one]->box);
        fill({open.begin() + half, open.end()}, false, places);
    }

  private:
    QPointF middle(std::size_t wish) const { return wishes_[wish].line.center(); }

    void fill(std::vector<std::size_t> members, bool left,
              std::vector<std::optional<LabelPlace>>& places) const {
        if (members.empty()) return;
        double width = 0;
        double height = 0;
        for (const std::size_t i : members) {
            width = std::max(width, wishes_[i].sizeAside.width());
            height = std::max(height, wishes_[i].sizeAside.height());
        }
        // The edge that looks at the lines.
        const double edge = left ? std::max(left_, std::min(inside_.left() + width, inside_.right()))
                                 : std::min(right_, std::max(inside_.right() - width, inside_.left()));
        const QRectF column(left ? edge - width : edge, inside_.top(), width, inside_.height());
        const double pitch = height + kBetween_px;
        const std::vector<Stretch> stretches = freeStretches(column, taken_);
        std::size_t most = 0;
        for (const Stretch& stretch : stretches) most += stretch.holds(pitch);
        if (members.size() > most) {
            std::sort(members.begin(), members.end());
            members.resize(most);
        }
        std::sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
            return std::tuple(middle(a).y(), middle(a).x(), a) < std::tuple(middle(b).y(), middle(b).x(), b);
        });
        std::vector<double> wished;
        for (const std::size_t i : members) wished.push_back(middle(i).y() - 0.5 * height);
        std::vector<double> tops;
        const std::vector<std::size_t> counts = shared(wished, stretches, pitch);
        for (std::size_t k = 0; k < stretches.size(); ++k) {
            const auto first = wished.begin() + static_cast<std::ptrdiff_t>(tops.size());
            const std::vector<double> part(first, first + static_cast<std::ptrdiff_t>(counts[k]));
            for (const double top : stacked(part, pitch, stretches[k].from, stretches[k].to + kBetween_px))
                tops.push_back(top);
        }
        const auto box = [&](std::size_t slot) {
            const QSizeF size = wishes_[members[slot]].sizeAside;
            return QRectF(QPointF(left ? edge - size.width() : edge, tops[slot]), size);
        };
        // From the side that looks at the line; from above or below where a column has no room beside it.
        const auto leader = [&](std::size_t slot) {
            const QRectF from = box(slot);
            const QPointF to = middle(members[slot]);
            const bool beside = left ? to.x() >= from.right() : to.x() <= from.left();
            if (beside) return QLineF(QPointF(edge, from.center().y()), to);
            const double x = std::clamp(to.x(), from.left() + 8, from.right() - 8);
            return QLineF(QPointF(x, to.y() < from.top() ? from.top() : from.bottom()), to);
        };
        // Exchanging two that cross makes both together shorter, so this ends.
        for (bool crossed = true; crossed;) {
            crossed = false;
            for (std::size_t a = 0; a < members.size(); ++a)
                for (std::size_t b = a + 1; b < members.size(); ++b) {
                    const double before = leader(a).length() + leader(b).length();
                    if (!cross(leader(a), leader(b))) continue;
                    std::swap(members[a], members[b]);
                    if (leader(a).length() + leader(b).length() < before - 1e-6)
                        crossed = true;
                    else
                        std::swap(members[a], members[b]);
                }
        }
        for (std::size_t slot = 0; slot < members.size(); ++slot) {
            places[members[slot]] = LabelPlace{box(slot), leader(slot)};
        }
    }

    const std::vector<LabelWish>& wishes_;
    QRectF inside_;
    std::vector<QRectF> taken_;
    double left_ = 0;
    double right_ = 0;
};

}  // namespace

std::vector<std::optional<LabelPlace>> placeLabels(const std::vector<LabelWish>& wishes,
                                                   const QRectF& picture, std::vector<QRectF> taken) {
    const QRectF inside = picture.adjusted(kEdge_px, kEdge_px, -kEdge_px, -kEdge_px);
    std::vector<QRectF> busy = taken;
    for (const LabelWish& wish : wishes) addLine(wish.line, busy);
    std::vector<std::optional<LabelPlace>> places(wishes.size());
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        const LabelWish& wish = wishes[i];
        if (wish.size.isEmpty()) continue;
        const bool room = wish.still || wish.line.length() > wish.size.width() + 12;
        const auto box =
            room ? choose(placesBeside(wish.line, wish.size, wish.still), inside, busy, wish.still)
                 : std::nullopt;
        if (!box) {
            open.push_back(i);
            continue;
        }
        places[i] = LabelPlace{*box, std::nullopt};
        taken.push_back(*box);
        busy.push_back(*box);
    }
    if (picture.width() < kNarrow_px || picture.height() < kLow_px) {
        // Those that must stand somewhere first, in a column; they are few.
        const auto others =
            std::stable_partition(open.begin(), open.end(), [&](std::size_t i) { return wishes[i].must; });
        std::vector<std::size_t> rest(others, open.end());
        open.erase(others, open.end());
        if (!open.empty()) Columns(wishes, inside, busy).place(open, places);
        for (const std::size_t i : open)
            if (places[i]) busy.push_back(places[i]->box);
        for (const std::size_t i : rest) {
            const auto box =
                choose(placesBeside(wishes[i].line, wishes[i].sizeBrief, false), inside, busy, false);
            if (!box) continue;
            places[i] = LabelPlace{*box, std::nullopt, true};
            busy.push_back(*box);
        }
    } else if (!open.empty()) {
        Columns(wishes, inside, busy).place(open, places);
    }
    for (const std::size_t i : open) {
        if (places[i] || !wishes[i].must) continue;
        const QSizeF& size = wishes[i].size;
        const auto box = choose(placesBeside(wishes[i].line, size, true), inside, busy, true);
        if (box) {
            places[i] = LabelPlace{*box, std::nullopt};
            continue;
        }
        // At the picture's edge: as near to its line as lies inside.
        QRectF at(wishes[i].line.center() - QPointF(0.5 * size.width(), size.height() + 9), size);
        at.moveLeft(std::max(inside.left(), std::min(at.left(), inside.right() - size.width())));
        at.moveTop(std::max(inside.top(), std::min(at.top(), inside.bottom() - size.height())));
        places[i] = LabelPlace{at, std::nullopt};
    }
    return places;
}

}  // namespace vestige

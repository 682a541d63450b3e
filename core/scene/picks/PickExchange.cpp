#include "core/scene/picks/PickExchange.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/base/CleanText.h"
#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/scene/PickFrame.h"
#include "core/scene/picks/PickLabel.h"

namespace vestige {
namespace {

std::string rowOf(const SceneState& scene, PickLabel label, const PickedPoint& point) {
    label.layer = point.layer;
    const Eigen::Vector3d at = scenePosition(scene, point);
    return csvLine({textOf(label), exactText(at.x()), exactText(at.y()), exactText(at.z())});
}

/// A repeat that is put together from its ends.
struct Gathered {
    std::size_t line = 0;  ///< of its first end
    std::map<std::size_t, PickedPoint> ends;
};
/// Object, key, path, repeat: in the order of the file's numbers.
using Place = std::tuple<std::string, std::string, bool, std::size_t>;

std::string lineOf(const std::string& place, std::size_t line) {
    return place + " line " + std::to_string(line);
}

/// Farther outside of the layer than it is wide, and than a scene may be.
bool isFar(const Layer& layer, const Eigen::Vector3d& position) {
    if (!layer.data || !layer.data->points || layer.data->points->empty()) return false;
    const BoundingBox box = layer.data->points->bounds().transformed(sceneFromLayer(layer));
    const Eigen::Vector3d outside = position - position.cwiseMax(box.min).cwiseMin(box.max);
    return outside.norm() > std::max(1000.0, box.diagonal());
}

Result<PickedPoint> pointOn(const SceneState& scene, const std::string& layer, const ListedPoint& point,
                            const std::string& place) {
    if (!scene.layer(layer))
        return fail(ErrorCode::input, "the case has no layer '" + cleanText(layer) + "'",
                    lineOf(place, point.line), "expected the id of a layer");
    if (isFar(*scene.layer(layer), point.position))
        return fail(
            ErrorCode::input, "the point lies far away from everything in layer '" + cleanText(layer) + "'",
            lineOf(place, point.line),
            "expected metres of the scene; a list in shifted coordinates needs its shift added first");
    return pickAt(scene, layer, point.position);
}

Result<std::map<Place, Gathered>> gatherLabelled(const SceneState& scene, std::span<const ListedPoint> points,
                                                 const std::string& place) {
    std::map<Place, Gathered> repeats;
    for (const ListedPoint& point : points) {
        const auto label = parsePickLabel(point.label);
        if (!label)
            return fail(ErrorCode::input, "the label is '" + cleanText(point.label) + "'",
                        lineOf(place, point.line),
                        "expected OBJECT | LAYER | REPEAT | a or b, as in the lines above");
        const auto made = pointOn(scene, label->layer, point, place);
        if (!made) return fail(made.error());
        Gathered& repeat = repeats[{label->object, label->key, label->ofPath, label->repeat}];
        if (repeat.ends.empty()) repeat.line = point.line;
        if (!repeat.ends.emplace(label->end, *made).second)
            return fail(ErrorCode::input, "'" + cleanText(point.label) + "' stands twice",
                        lineOf(place, point.line), "expected each end once");
    }
    for (const auto& [where, repeat] : repeats) {
        const bool ofPath = std::get<2>(where);
        const std::size_t wanted = ofPath ? repeat.ends.rbegin()->first + 1 : 2;
        if (repeat.ends.size() != wanted)
            return fail(ErrorCode::input,
                        "repeat " + std::to_string(std::get<3>(where)) + " of '" +
                            cleanText(std::get<0>(where)) + "' lacks an end",
                        lineOf(place, repeat.line),
                        "expected a and b of each pair, p1 to the last of each path");
    }
    return repeats;
}

Result<std::map<Place, Gathered>> gatherPairs(const SceneState& scene, std::span<const ListedPoint> points,
                                              const PicksTarget& target, const std::string& place) {
    if (points.size() % 2 != 0)
        return fail(
            ErrorCode::input, "the last of " + std::to_string(points.size()) + " points has no partner",
            lineOf(place, points.back().line), "expected two points for each repeat, one after the other");
    std::map<Place, Gathered> repeats;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto made = pointOn(scene, target.layer, points[i], place);
        if (!made) return fail(made.error());
        Gathered& repeat = repeats[{target.object, target.layer, false, i / 2}];
        if (i % 2 == 0) repeat.line = points[i].line;
        repeat.ends.emplace(i % 2, *made);
    }
    return repeats;
}

bool samePlace(const SceneState& scene, const PickedPoint& a, const PickedPoint& b) {
    // Frames turned there and back differ in the last digits.
    return a.layer == b.layer && (scenePosition(scene, a) - scenePosition(scene, b)).norm() <= 1e-7;
}

/// Which repeats of the case a list has named already: of several that lie on one place, each counts once.
using Named = std::map<std::tuple<std::string, std::string, bool>, std::vector<bool>>;

/// False where the case has it.
template <class Repeat, class Same>
bool addUnknown(std::vector<Repeat>& repeats, Repeat repeat, std::vector<bool>& named, const Same& same) {
    for (std::size_t i = 0; i < named.size(); ++i) {
        if (named[i] || !same(repeats[i], repeat)) continue;
        named[i] = true;
        return false;
    }
    repeats.push_back(std::move(repeat));
    return true;
}

bool add(const SceneState& scene, Measurement& measurement, const Place& where, const Gathered& gathered,
         Named& named) {
    const auto& [object, key, ofPath, repeat] = where;
    const auto known = [&named, &ofObject = object, &ofKey = key,
                        isPath = ofPath](std::size_t count) -> std::vector<bool>& {
        return named.try_emplace({ofObject, ofKey, isPath}, count, false).first->second;
    };
    if (!ofPath) {
        auto& pairs = measurement.picks[key];
        return addUnknown(pairs, PickedPair{gathered.ends.at(0), gathered.ends.at(1)}, known(pairs.size()),
                          [&](const PickedPair& p, const PickedPair& q) {
                              return samePlace(scene, p.a, q.a) && samePlace(scene, p.b, q.b);
                          });
    }
    PickedPath path;
    for (const auto& [corner, point] : gathered.ends) path.push_back(point);
    auto& paths = measurement.paths[key];
    return addUnknown(
        paths, std::move(path), known(paths.size()), [&](const PickedPath& p, const PickedPath& q) {
            return std::equal(
                p.begin(), p.end(), q.begin(), q.end(),
                [&](const PickedPoint& a, const PickedPoint& b) { return samePlace(scene, a, b); });
        });
}

}  // namespace

std::string picksCsv(const SceneState& scene) {
    std::string csv = csvLine({"label", "x", "y", "z"});
    for (const Measurement& measurement : scene.measurements) {
        for (const auto& [key, pairs] : measurement.picks)
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                csv += rowOf(scene, {measurement.object, key, i + 1, false, 0, {}}, pairs[i].a);
                csv += rowOf(scene, {measurement.object, key, i + 1, false, 1, {}}, pairs[i].b);
            }
        for (const auto& [key, paths] : measurement.paths)
            for (std::size_t i = 0; i < paths.size(); ++i)
                for (std::size_t corner = 0; corner < paths[i].size(); ++corner)
                    csv += rowOf(scene, {measurement.object, key, i + 1, true, corner, {}}, paths[i][corner]);
    }
    return csv;
}

Result<ImportedPicks> importPicks(const SceneState& scene, std::span<const ListedPoint> points,
                                  const PicksTarget& target, const std::string& place) {
    if (points.empty()) return fail(ErrorCode::input, "there are no points", place);
    const bool labelled = parsePickLabel(points.front().label).has_value();
    const auto repeats =
        labelled ? gatherLabelled(scene, points, place) : gatherPairs(scene, points, target, place);
    if (!repeats) return fail(repeats.error());
    ImportedPicks imported;
    Named named;
    for (const auto& [where, gathered] : *repeats) {
        const auto& [object, key, ofPath, repeat] = where;
        const auto isIt = [&object = object](const Measurement& m) { return m.object == object; };
        auto found = std::find_if(imported.changed.begin(), imported.changed.end(), isIt);
        if (found == imported.changed.end()) {
            Measurement fresh;
            fresh.object = object;
            if (ofPath) fresh.kind = MeasurementKind::polyline;
            const Measurement* known = scene.measurement(object);
            imported.changed.push_back(known ? *known : std::move(fresh));
            found = imported.changed.end() - 1;
        }
        ++(add(scene, *found, where, gathered, named) ? imported.repeats : imported.known);
    }
    return imported;
}

}  // namespace vestige

#include "ui/view/ClassColors.h"

#include <QCoreApplication>
#include <array>

namespace vestige {
namespace {

struct PointClass {
    const char* name;
    Rgb color;
};

constexpr const char* kContext = "PointClass";
constexpr std::array<PointClass, 23> kClasses{{
    {QT_TRANSLATE_NOOP("PointClass", "never classified"), {150, 158, 168}},
    {QT_TRANSLATE_NOOP("PointClass", "unclassified"), {186, 192, 200}},
    {QT_TRANSLATE_NOOP("PointClass", "ground"), {176, 134, 88}},
    {QT_TRANSLATE_NOOP("PointClass", "low vegetation"), {170, 214, 110}},
    {QT_TRANSLATE_NOOP("PointClass", "medium vegetation"), {104, 180, 84}},
    {QT_TRANSLATE_NOOP("PointClass", "high vegetation"), {52, 138, 72}},
    {QT_TRANSLATE_NOOP("PointClass", "building"), {226, 112, 92}},
    {QT_TRANSLATE_NOOP("PointClass", "low noise"), {196, 74, 178}},
    {QT_TRANSLATE_NOOP("PointClass", "model key point"), {240, 226, 150}},
    {QT_TRANSLATE_NOOP("PointClass", "water"), {74, 144, 226}},
    {QT_TRANSLATE_NOOP("PointClass", "rail"), {142, 110, 200}},
    {QT_TRANSLATE_NOOP("PointClass", "road surface"), {128, 142, 160}},
    {QT_TRANSLATE_NOOP("PointClass", "overlap"), {214, 168, 206}},
    {QT_TRANSLATE_NOOP("PointClass", "wire, guard"), {232, 200, 74}},
    {QT_TRANSLATE_NOOP("PointClass", "wire, conductor"), {244, 154, 52}},
    {QT_TRANSLATE_NOOP("PointClass", "transmission tower"), {170, 120, 60}},
    {QT_TRANSLATE_NOOP("PointClass", "wire connector"), {210, 150, 110}},
    {QT_TRANSLATE_NOOP("PointClass", "bridge deck"), {120, 196, 206}},
    {QT_TRANSLATE_NOOP("PointClass", "high noise"), {232, 70, 110}},
    {QT_TRANSLATE_NOOP("PointClass", "overhead structure"), {96, 210, 180}},
    {QT_TRANSLATE_NOOP("PointClass", "ignored ground"), {146, 118, 96}},
    {QT_TRANSLATE_NOOP("PointClass", "snow"), {226, 238, 248}},
    {QT_TRANSLATE_NOOP("PointClass", "temporal exclusion"), {110, 100, 130}},
}};
constexpr std::array<Rgb, 6> kOthers{
    {{250, 128, 200}, {130, 220, 240}, {200, 230, 90}, {255, 190, 120}, {160, 150, 255}, {120, 240, 150}}};
constexpr std::uint8_t kFirstOfUsers = 64;
constexpr std::size_t kMostLookedAt = 4000000;

}  // namespace

QString className(std::uint8_t code) {
    if (code < kClasses.size()) return QCoreApplication::translate(kContext, kClasses[code].name);
    if (code < kFirstOfUsers) return QCoreApplication::translate(kContext, "reserved");
    return QCoreApplication::translate(kContext, "of the user");
}

Rgb classColor(std::uint8_t code, Theme theme) {
    return onTheme(code < kClasses.size() ? kClasses[code].color : kOthers[code % kOthers.size()], theme);
}

std::vector<std::uint8_t> classesShown(const ViewDescription& view) {
    std::array<bool, 256> seen{};
    for (const ViewLayer& layer : view.layers) {
        if (!isDrawn(layer) || !layer.geometry) continue;
        const std::vector<std::uint8_t>& classes = layer.geometry->vertices.attributes().classification;
        const std::size_t stride = classes.size() / kMostLookedAt + 1;
        for (std::size_t i = 0; i < classes.size(); i += stride) seen[classes[i]] = true;
    }
    std::vector<std::uint8_t> found;
    for (std::size_t code = 0; code < seen.size(); ++code)
        if (seen[code]) found.push_back(static_cast<std::uint8_t>(code));
    return found;
}

}  // namespace vestige

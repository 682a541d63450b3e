#include <gtest/gtest.h>

#include "core/io/CleanTexts.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/E57Craft.h"
#include "tests/core/io/S3mbFiles.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// What a terminal takes for orders, and half of a UTF-8 character.
const std::string kHostile = "\x1b[2J\x07\xc3";

bool isClean(const std::string& text) {
    return text.find('\x1b') == std::string::npos && text.find('\x07') == std::string::npos &&
           text.find('\xc3') == std::string::npos && text.size() < 2000;
}

void expectCleanRefusal(const std::string& name, const std::string& content, const std::string& says) {
    const TemporaryFolder folder;
    writeBytes(folder / name, content);
    const Result<LoadedGeometry> loaded = readGeometry(folder / name);
    ASSERT_FALSE(loaded) << says;
    EXPECT_NE(loaded.error().message.find(says), std::string::npos) << loaded.error().message;
    EXPECT_TRUE(isClean(loaded.error().sentence())) << loaded.error().sentence();
    const Result<FileInfo> peeked = peekFile(folder / name);
    EXPECT_TRUE(peeked || isClean(peeked.error().sentence()));
}

}  // namespace

TEST(CleanTexts, RefusalsQuoteNoOrdersToTheTerminalAndNoBooks) {
    const std::string escaped = R"(\u001b[2J\u0007)";
    expectCleanRefusal("a.json", R"({"asset":{"version":"1.0"},"root":{"refine":")" + escaped + "\"}}",
                       "refines by");
    expectCleanRefusal("a.scp", s3mbIndex(escaped, {"b.s3mb"}), "lodType");
    expectCleanRefusal("a.gltf", R"({"asset":{"version":"2.0"},"extensionsRequired":[")" + escaped + "\"]}",
                       "requires the extension");
    const std::string accessor =
        R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":")";
    expectCleanRefusal("b.gltf", accessor + escaped + std::string(5000, 'x') + "\"}]}", "holds '");
}

TEST(CleanTexts, WhatAFileSaysOfItselfIsTextAlone) {
    FileInfo info;
    info.version = info.generatingSoftware = info.damage = kHostile + "version";
    info.crs = "PROJCS[\"a\",\n\tGEOGCS" + kHostile + "]";
    info.warnings = {kHostile, std::string(5000, 'w')};
    info.attributes = {kHostile};
    info.scans.resize(1);
    info.scans[0].name = info.scans[0].guid = info.scans[0].sensorModel = kHostile;
    info.images.resize(1);
    info.images[0].name =
        "Gr\xc3\xb6\xc3\x9f"
        "e";
    cleanTexts(info);
    EXPECT_EQ(info.version, "?[2J??version");
    EXPECT_EQ(info.crs, "PROJCS[\"a\",  GEOGCS?[2J??]");
    EXPECT_EQ(info.images[0].name,
              "Gr\xc3\xb6\xc3\x9f"
              "e");
    for (const std::string& text :
         {info.generatingSoftware, info.damage, info.warnings[0], info.warnings[1], info.attributes[0],
          info.scans[0].name, info.scans[0].guid, info.scans[0].sensorModel})
        EXPECT_TRUE(isClean(text)) << text;
}

TEST(CleanTexts, TheNamesInAnE57FileAreClean) {
    E57Craft craft;
    const std::uint64_t at =
        craft.section(E57Craft::packet({bytesOf<double>({1}), bytesOf<double>({2}), bytesOf<double>({3})}));
    const TemporaryFolder folder;
    writeBytes(
        folder / "a.e57",
        craft.file(E57Craft::root(E57Craft::scan(
            at, 1, "<cartesianX type=\"Float\"/><cartesianY type=\"Float\"/><cartesianZ type=\"Float\"/>",
            "<name type=\"String\"><![CDATA[" + kHostile + "]]></name>"))));
    for (const FileInfo& info : {readOrFail(folder / "a.e57").info, *peekFile(folder / "a.e57")}) {
        ASSERT_EQ(info.scans.size(), 1);
        EXPECT_TRUE(isClean(info.scans[0].name)) << info.scans[0].name;
    }
}

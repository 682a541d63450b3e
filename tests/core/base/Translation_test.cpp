#include "core/base/Translation.h"

#include <algorithm>

#include <gtest/gtest.h>
#include "core/base/Catalogue.h"
#include "core/base/TextTemplate.h"

namespace vestige {
namespace {

const Translator kChinese(Language::simplifiedChinese);

Translator withNames(std::set<std::string, std::less<>> names) {
    return {Language::simplifiedChinese, std::move(names)};
}

TEST(TextTemplate, FindsWhatStandsAtItsPlaces) {
    const TextTemplate form("only %1 of %2 starts came back");
    const auto values = form.match("only 3 of 4 starts came back");
    ASSERT_TRUE(values);
    EXPECT_EQ((*values)[0], "3");
    EXPECT_EQ((*values)[1], "4");
    EXPECT_FALSE(form.match("only 3 of 4 starts came"));
    EXPECT_FALSE(form.match("not only 3 of 4 starts came back"));
    EXPECT_EQ(TextTemplate("%2 before %1").filled({"b", "a"}), "a before b");
}

TEST(TextTemplate, TriesALaterPieceWhereTheFirstLeadsNowhere) {
    const auto values = TextTemplate("%1 of %2 left").match("a of b of c left");
    ASSERT_TRUE(values);
    EXPECT_EQ((*values)[0], "a");
    EXPECT_EQ((*values)[1], "b of c");
    EXPECT_TRUE(TextTemplate("the disk refused%1").match("the disk refused"));
}

TEST(Catalogue, IsInTheOrderThatIsSearched) {
    const auto entries = catalogue(Language::simplifiedChinese);
    EXPECT_GT(entries.size(), 1000u);
    EXPECT_TRUE(std::is_sorted(entries.begin(), entries.end(),
                               [](const auto& a, const auto& b) { return a.english < b.english; }));
    EXPECT_TRUE(catalogue(Language::english).empty());
}

TEST(Translation, LeavesEnglishAsItIs) {
    EXPECT_EQ(say("the file is empty"), "the file is empty");
    EXPECT_EQ(say("Page %1 of %2", {"2", "9"}), "Page 2 of 9");
    const Error error{ErrorCode::input, "the file is empty", "a.las", "expected: a point cloud or a mesh"};
    EXPECT_EQ(say(error), error.sentence());
}

TEST(Translation, SaysAWholeText) {
    EXPECT_EQ(kChinese("the file is empty"), "文件为空");
    EXPECT_EQ(kChinese("The file is empty"), "The file is empty");
}

TEST(Translation, SaysATextThatWasJoinedFromParts) {
    EXPECT_EQ(kChinese("only 3 of 4 perturbed starts came back to this pose"),
              "4 次扰动重启中只有 3 次回到此位姿");
    EXPECT_EQ(
        kChinese("the data do not hold the scan: it slides level roughly east-west (84° from the y axis)"),
        "数据未能约束扫描：它沿大致东西（与 y 轴成 84°）方向水平滑动");
}

TEST(Translation, SaysSeveralTextsBehindEachOther) {
    EXPECT_EQ(kChinese("the file is empty; the disk is full"), "文件为空；磁盘已满");
    EXPECT_EQ(kChinese("aerial.las: the file is empty"), "aerial.las：文件为空");
    EXPECT_EQ(kChinese("the file is empty."), "文件为空。");
    EXPECT_EQ(kChinese("Of some files only a part was loaded: front: one of every 4 points."),
              "有些文件只载入了一部分：front：每 4 个点取一个。");
}

TEST(Translation, NeedsAFigureWhereATemplateHasLittleElse) {
    EXPECT_EQ(kChinese("12 steps"), "12 步");
    EXPECT_EQ(kChinese("wooden steps"), "wooden steps");
}

TEST(Translation, LeavesNamesAlone) {
    EXPECT_EQ(kChinese("rename target"), "重命名 target");
    EXPECT_EQ(kChinese("remove layer 'the disk is full'"), "移除图层“the disk is full”");
    EXPECT_EQ(withNames({"Width, front"})("Width, front, lidar"), "Width, front，激光扫描");
    const Translator say = withNames({"yes", "not measurable", "Hood and roof", "Door"});
    EXPECT_EQ(say("yes"), "yes");
    EXPECT_EQ(say("Not measurable: not measurable."), "无法测量：not measurable。");
    const Translator cars =
        withNames({"Width of the car", "Length of the car", "Length of the car's box", "Box"});
    EXPECT_EQ(cars("Not measurable: Length of the car's box (激光扫描), Box (激光扫描) and Width of the car "
                   "(激光扫描)."),
              "无法测量：Length of the car's box (激光扫描)、Box (激光扫描)和Width of the car (激光扫描)。");
    EXPECT_EQ(cars("pick Length of the car, repeat 2"), "点选 Length of the car，第 2 次");
    EXPECT_EQ(say("Not measurable: yes, Hood and roof and Door."), "无法测量：yes、Hood and roof和Door。");
}

TEST(Translation, LeavesWhatItDoesNotKnow) {
    for (const char* text : {"", "12.5", "Hinterer Kotflügel; links", "a b c d e f g", "x: y: z. q"})
        EXPECT_EQ(kChinese(text), text);
}

TEST(Translation, GivesTheProcessItsLanguage) {
    setLanguage(Language::simplifiedChinese);
    const std::string whole =
        say({ErrorCode::output, "the disk is full", "case.db", "save it under another name"});
    const std::string page = say("Page %1 of %2", {"2", "9"});
    setLanguage(Language::english);
    EXPECT_EQ(whole, "case.db：磁盘已满；请以其他名称保存");
    EXPECT_EQ(page, "第 2 页，共 9 页");
}

TEST(Language, IsReadFromNamesOfLocales) {
    for (const char* locale : {"zh_CN.UTF-8", "zh_CN", "zh", "zh-Hans-CN", "zh_SG"})
        EXPECT_EQ(languageOfLocale(locale), Language::simplifiedChinese) << locale;
    for (const char* locale : {"zh_TW", "zh-Hant-HK", "en_GB", "C", "", "zhx"})
        EXPECT_EQ(languageOfLocale(locale), Language::english) << locale;
    EXPECT_EQ(languageFromName("zh_CN"), Language::simplifiedChinese);
    EXPECT_FALSE(languageFromName("zh"));
}

}  // namespace
}  // namespace vestige

#include "core/base/CleanText.h"

#include <gtest/gtest.h>

using vestige::cleanText;

TEST(CleanText, KeepsWhatPeopleWrite) {
    EXPECT_EQ(cleanText("Intensität 5 µm"), "Intensität 5 µm");
    EXPECT_EQ(cleanText("点云 😀"), "点云 😀");
    EXPECT_EQ(cleanText(""), "");
}

TEST(CleanText, ControlCharactersAndWhatIsNoUtf8BecomeQuestionMarks) {
    EXPECT_EQ(cleanText("a\x1b[31mb\nc\x7f"), "a?[31mb?c?");
    EXPECT_EQ(cleanText(std::string_view("\0x", 2)), "?x");
    EXPECT_EQ(cleanText("\xff\xfe"), "??");
    EXPECT_EQ(cleanText("\xc0\xaf"), "??") << "an overlong slash";
    EXPECT_EQ(cleanText("\xed\xa0\x80"), "???") << "half of a surrogate pair";
    EXPECT_EQ(cleanText("\xf4\x90\x80\x80"), "????") << "beyond Unicode";
    EXPECT_EQ(cleanText("\xc2\x85"), "?") << "a control character of two bytes";
    EXPECT_EQ(cleanText("\xe2\x82"), "??") << "cut off";
}

TEST(CleanText, LongTextIsCutBetweenCharacters) {
    EXPECT_EQ(cleanText("abcdef", 4), "abcd...");
    EXPECT_EQ(cleanText("abcdef", 6), "abcdef");
    EXPECT_EQ(cleanText("aéé", 4), "aé...");
}

#include "ui/print/PdfPrinter.h"

#include <QImage>
#include <QProcess>
#include <QRawFont>
#include <QRegularExpression>
#include <fstream>
#include <set>

#include <gtest/gtest.h>
#include "core/base/AtomicFile.h"
#include "core/base/Catalogue.h"
#include "core/base/Translation.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/print/PdfFile.h"
#include "ui/print/PageStyle.h"

namespace vestige {
namespace {

using test::PdfObject;
using test::readPdf;
using test::TemporaryFolder;

/// A picture with an alpha channel, as a careless renderer might give it.
std::filesystem::path translucentPng(const TemporaryFolder& folder) {
    QImage image(280, 180, QImage::Format_ARGB32);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) image.setPixelColor(x, y, QColor(x % 256, y, 90, 128));
    const auto png = folder / "view.png";
    image.save(QString::fromStdString(png.string()));
    return png;
}

Report reportOfEveryBlock(const std::filesystem::path& png, int rows) {
    Report report;
    report.title = "Measurement report";
    report.subtitle = "Road-accident scene";
    report.caseName = "Two cars <A & B>";
    report.operatorName = "M. Muster";
    report.date = "2026-11-22T07:00:00Z";
    report.software = "Vestige 0.1.0";
    Table table{"Measured lengths",
                {"Object", "Method", "Tape (m)", "Mean (m)", "RE (%)"},
                {false, false, true, true, true},
                {},
                {1},
                {}};
    for (int i = 0; i < rows; ++i)
        table.rows.push_back(
            {"Right rear-view mirror of vehicle " + std::to_string(i), "lidar", "0.21", "0.2143", "+2.0"});
    BarChart chart{"Relative error by object", "%", {"Length of the white vehicle", "Width", "Mirror"}, {}};
    chart.series.push_back({"lidar", {0.4, -1.2, 7.5}, {false, false, true}});
    chart.series.push_back({"photogrammetry", {1.4, {}, -3.0}, {}});
    report.sections = {
        {"Facts", {Paragraph{"A sentence that explains."}, Facts{{{"SHA-256", std::string(64, 'a')}}}}},
        {"Table", {table}},
        {"Pictures",
         {Picture{png, "The whole scene", 1}, Picture{png, "Left", 0.5}, Picture{png, "Right", 0.5}, chart}}};
    return report;
}

class PdfPrinting : public testing::Test {
  protected:
    void print(int rows = 12) {
        PdfPrinter printer;
        const Status printed = printer.printPdf(reportOfEveryBlock(translucentPng(folder), rows), pdf, {});
        ASSERT_TRUE(printed) << printed.error().sentence();
        objects = readPdf(pdf);
        ASSERT_GT(objects.size(), 10u);
    }

    int countIn(const QRegularExpression& pattern) const {
        int count = 0;
        for (const PdfObject& object : objects)
            count += pattern.match(QString::fromLatin1(object.dictionary)).hasMatch() ? 1 : 0;
        return count;
    }

    TemporaryFolder folder;
    std::filesystem::path pdf = folder / "report.pdf";
    std::vector<PdfObject> objects;
};

TEST_F(PdfPrinting, PaintsNothingTranslucent) {
    print();
    const QRegularExpression alpha("/(?:ca|CA)\\s+([0-9.]+)");
    for (const PdfObject& object : objects) {
        const QString text = QString::fromLatin1(object.dictionary);
        for (auto found = alpha.globalMatch(text); found.hasNext();)
            EXPECT_EQ(found.next().captured(1).toDouble(), 1.0) << object.dictionary.constData();
        EXPECT_FALSE(QRegularExpression("/SMask\\s+(?!/None)").match(text).hasMatch());
        EXPECT_FALSE(text.contains("/Transparency"));
        EXPECT_FALSE(QRegularExpression("/Interpolate\\s+true").match(text).hasMatch());
    }
    EXPECT_EQ(countIn(QRegularExpression("/Subtype\\s*/Image")), 3)
        << "the pictures are in the file, without masks";
}

TEST_F(PdfPrinting, EmbedsEveryFont) {
    print();
    const int fonts = countIn(QRegularExpression("/Type\\s*/FontDescriptor"));
    EXPECT_GE(fonts, 2);
    EXPECT_EQ(countIn(QRegularExpression("/FontFile[23]?\\s+\\d+ 0 R")), fonts);
    EXPECT_EQ(countIn(QRegularExpression("/BaseFont\\s*/(Helvetica|Times|Courier)")), 0);
}

TEST_F(PdfPrinting, GivesItsTextToWhoeverSearchesOrCopies) {
    const std::string sentence = "It was 4.51 m (RE) on 2026-11-22 at 08:07: +1.1 % of the first, x - y.";
    Report report = reportOfEveryBlock(translucentPng(folder), 3);
    report.sections.front().blocks.insert(report.sections.front().blocks.begin(), Paragraph{sentence});
    ASSERT_TRUE(PdfPrinter().printPdf(report, pdf, {}));
    QProcess reader;
    reader.start("pdftotext", {"-layout", QString::fromStdString(pdf.string()), "-"});
    if (!reader.waitForStarted()) GTEST_SKIP() << "pdftotext is not installed";
    ASSERT_TRUE(reader.waitForFinished());
    const std::string text = reader.readAllStandardOutput().toStdString();
    for (const char* part :
         {sentence.c_str(), "SHA-256", "Right rear-view mirror of vehicle 1", "0.2143", "+2.0"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " is not in:\n" << text;
}

/// Everything that is set now is Chinese.
struct InChinese {
    InChinese() { setLanguage(Language::simplifiedChinese); }
    ~InChinese() { setLanguage(Language::english); }
};

TEST_F(PdfPrinting, SetsChineseThatCanBeSearchedAndCopied) {
    const InChinese chinese;
    Report report = reportOfEveryBlock(translucentPng(folder), 60);
    report.title = "现场测量报告";
    const std::string sentence = "扩展不确定度为 0.014 m（95 %），见“长度的不确定度”；SHA-256: 2026-11-22。";
    std::string longOne;
    for (int i = 0; i < 12; ++i) longOne += sentence;
    report.sections.front().blocks = {Paragraph{sentence}, Paragraph{longOne}};
    ASSERT_TRUE(PdfPrinter().printPdf(report, pdf, {}));
    objects = readPdf(pdf);
    const int fonts = countIn(QRegularExpression("/Type\\s*/FontDescriptor"));
    EXPECT_GE(fonts, 1);
    EXPECT_EQ(countIn(QRegularExpression("/FontFile[23]?\\s+\\d+ 0 R")), fonts);
    EXPECT_EQ(countIn(QRegularExpression("/S\\s*/GTS_PDFA1")), 1);
    QProcess reader;
    reader.start("pdftotext", {"-layout", QString::fromStdString(pdf.string()), "-"});
    if (!reader.waitForStarted()) GTEST_SKIP() << "pdftotext is not installed";
    ASSERT_TRUE(reader.waitForFinished());
    const QString text = QString::fromUtf8(reader.readAllStandardOutput());
    for (const char* part : {"现场测量报告", sentence.c_str(), "报告日期", "第 1 页，共", "（续）", "0.2143"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << " is not in:\n" << text.toStdString();
    // Lines of Chinese break between characters, and none begins with a mark that closes something.
    for (const QString& line : text.split('\n'))
        EXPECT_FALSE(QStringLiteral("，。；：、）”").contains(line.trimmed().left(1)) &&
                     !line.trimmed().isEmpty())
            << line.toStdString();
}

TEST_F(PdfPrinting, HasAGlyphForEveryCharacterOfTheTranslations) {
    const InChinese chinese;
    const QRawFont font = QRawFont::fromFont(PageStyle().font(9));
    const QRawFont symbols =
        QRawFont::fromFont(QFont("DejaVu Sans"));  // stands in for what Chinese fonts lack
    std::set<uint> missing;
    for (const CatalogueEntry& entry : catalogue(Language::simplifiedChinese))
        for (const uint character :
             QString::fromUtf8(entry.translated.data(), static_cast<int>(entry.translated.size())).toUcs4())
            if (character > 32 && !font.supportsCharacter(character) && !symbols.supportsCharacter(character))
                missing.insert(character);
    for (const uint character : missing)
        ADD_FAILURE() << "no glyph for " << QString::fromUcs4(&character, 1).toStdString() << " in "
                      << font.familyName().toStdString();
}

TEST_F(PdfPrinting, HoldsPicturesNoFinerThanPrintShows) {
    QImage noise(1400, 900, QImage::Format_RGB32);
    std::uint32_t state = 1;
    for (int y = 0; y < noise.height(); ++y)
        for (int x = 0; x < noise.width(); ++x) {
            state = state * 1664525u + 1013904223u;
            noise.setPixel(x, y, qRgb(state >> 24, state >> 16 & 255, 90));
        }
    const auto png = folder / "noise.png";
    ASSERT_TRUE(noise.save(QString::fromStdString(png.string())));
    Report report = reportOfEveryBlock(png, 3);
    ASSERT_TRUE(PdfPrinter().printPdf(report, pdf, {}));
    objects = readPdf(pdf);
    int widest = 0;
    const QRegularExpression width("/Width (\\d+)");
    for (const PdfObject& object : objects) {
        const QString dictionary = QString::fromLatin1(object.dictionary);
        if (!dictionary.contains(QRegularExpression("/Subtype\\s*/Image"))) continue;
        EXPECT_TRUE(dictionary.contains("/DCTDecode")) << object.dictionary.constData();
        widest = std::max(widest, width.match(dictionary).captured(1).toInt());
    }
    EXPECT_GT(widest, 1000);
    EXPECT_LE(widest, 1400);
    // Two of the three stand side by side, with half as many pixels each way.
    EXPECT_LT(std::filesystem::file_size(pdf), std::filesystem::file_size(png));
}

TEST_F(PdfPrinting, MakesAPictureSmallerRatherThanLeaveAPageHalfEmpty) {
    const auto pages = [&](int paragraphs) {
        Report report = reportOfEveryBlock(translucentPng(folder), 3);
        std::vector<Block> blocks;
        for (int i = 0; i < paragraphs; ++i) blocks.emplace_back(Paragraph{"One line."});
        blocks.emplace_back(Picture{folder / "view.png", "The whole scene", 1});
        report.sections = {{"Pictures", std::move(blocks)}};
        EXPECT_TRUE(PdfPrinter().printPdf(report, pdf, {}));
        objects = readPdf(pdf);
        return countIn(QRegularExpression("/Type\\s*/Page\\b"));
    };
    const double line = 6.6;     // mm of a paragraph of one line, with the gap below
    const double picture = 108;  // mm of its wished height
    const int fits = static_cast<int>((246 - 60 - picture) / line);
    EXPECT_EQ(pages(fits - 1), 1);
    EXPECT_EQ(pages(fits + 3), 1);
    EXPECT_EQ(pages(fits + 9), 2);
}

TEST_F(PdfPrinting, SaysThatItIsPdfA1bInSrgb) {
    print();
    EXPECT_EQ(countIn(QRegularExpression("/S\\s*/GTS_PDFA1")), 1);
    QByteArray metadata;
    for (const PdfObject& object : objects)
        if (object.dictionary.contains("/Metadata") && !object.stream.isEmpty()) metadata = object.stream;
    EXPECT_TRUE(QRegularExpression("pdfaid:part.{0,2}1").match(QString::fromUtf8(metadata)).hasMatch());
    EXPECT_TRUE(
        QRegularExpression("pdfaid:conformance.{0,2}B").match(QString::fromUtf8(metadata)).hasMatch());
    EXPECT_TRUE(metadata.contains("Two cars &lt;A &amp; B&gt;")) << "the case's name must not break the XML";
}

TEST_F(PdfPrinting, BreaksLongTablesAcrossPages) {
    print(12);
    const int few = countIn(QRegularExpression("/Type\\s*/Page\\b"));
    print(150);
    EXPECT_GE(countIn(QRegularExpression("/Type\\s*/Page\\b")), few + 2);
}

TEST_F(PdfPrinting, LeavesWhatStoodThereWhenAPictureIsMissing) {
    ASSERT_TRUE(writeTextFile(pdf, "before"));
    const Status printed = PdfPrinter().printPdf(reportOfEveryBlock(folder / "absent.png", 3), pdf, {});
    ASSERT_FALSE(printed);
    EXPECT_EQ(printed.error().code, ErrorCode::output);
    EXPECT_NE(printed.error().sentence().find("absent.png"), std::string::npos);
    EXPECT_EQ(readTextFile(pdf).value(), "before");
}

TEST_F(PdfPrinting, StopsWhenCancelled) {
    const JobControl control;
    control.cancel();
    const Status printed = PdfPrinter().printPdf(reportOfEveryBlock(translucentPng(folder), 3), pdf, control);
    ASSERT_FALSE(printed);
    EXPECT_EQ(printed.error().code, ErrorCode::cancelled);
    EXPECT_FALSE(std::filesystem::exists(pdf));
}

}  // namespace
}  // namespace vestige

#include "ui/document/History.h"

#include <gtest/gtest.h>

#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "ui/document/Document.h"

namespace vestige {
namespace {

void add(Document& document, const std::string& object) {
    Measurement measurement;
    measurement.object = object;
    document.perform(setMeasurement(std::move(measurement), "add " + object));
}

QStringList textsOf(const History& history) {
    QStringList texts;
    for (const History::Step& step : history.steps()) texts << step.text;
    return texts;
}

TEST(History, TellsEveryStepAndWhereTheCaseIs) {
    Document document;
    History history(document);
    EXPECT_EQ(history.done(), 0u);
    add(document, "A");
    document.begin("two at once");
    add(document, "B");
    add(document, "C");
    document.end();
    add(document, "D");
    EXPECT_EQ(textsOf(history), (QStringList{"add A", "two at once", "add D"}));
    EXPECT_EQ(history.done(), 3u);
    document.undo();
    document.undo();
    EXPECT_EQ(history.done(), 1u);
    EXPECT_EQ(textsOf(history).size(), 3);
    document.redo();
    EXPECT_EQ(history.done(), 2u);
    add(document, "E");
    EXPECT_EQ(textsOf(history), (QStringList{"add A", "two at once", "add E"})) << "what was undone is gone";
}

TEST(History, GoesToAnyStepAndTellsOfItOnce) {
    Document document;
    History history(document);
    std::vector<std::string> states{caseText(document.state())};
    for (const char* object : {"A", "B", "C", "D", "E"}) {
        add(document, object);
        states.push_back(caseText(document.state()));
    }
    int told = 0;
    QObject::connect(&document, &Document::changed, &document, [&told] { ++told; });
    for (const std::size_t done : {0u, 5u, 2u, 3u, 1u, 4u, 4u, 9u}) {
        told = 0;
        const bool moves = std::min<std::size_t>(done, 5) != history.done();
        history.goTo(done);
        EXPECT_EQ(told, moves ? 1 : 0);
        EXPECT_EQ(history.done(), std::min<std::size_t>(done, 5));
        EXPECT_EQ(caseText(document.state()), states[history.done()]);
        EXPECT_EQ(textsOf(history).size(), 5);
    }
}

TEST(History, ANewCaseHasNone) {
    Document document;
    History history(document);
    add(document, "A");
    document.replace(SceneState());
    EXPECT_TRUE(history.steps().empty());
    EXPECT_EQ(history.done(), 0u);
    add(document, "B");
    EXPECT_EQ(textsOf(history), QStringList{"add B"});
}

}  // namespace
}  // namespace vestige

// Works on a case as fast as it can, until it is killed, and tells on stdout what it did: "made K VALUE"
// before edit K leaves the operator's name as VALUE, "stored K" when that edit is said to outlast everything.
// Arguments: folder of the test, seed, first value, rounds (0: until killed), "untitled" or "case".

#include <unistd.h>

#include <QCoreApplication>
#include <QTimer>
#include <fstream>
#include <iostream>
#include <random>

#include "core/base/AtomicFile.h"
#include "core/base/OutputFolder.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "ui/document/Autosave.h"
#include "ui/document/Document.h"

namespace {

using namespace vestige;

/// In one piece, whoever kills us.
void tell(const std::string& line) {
    const std::string text = line + "\n";
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0) ::_exit(4);
}

class Worker {
  public:
    Worker(std::filesystem::path folder, unsigned seed, long first, bool untitled)
        : folder_(std::move(folder)),
          random_(seed),
          value_(first),
          untitled_(untitled),
          autosave_(document_, folder_ / "autosave") {
        QObject::connect(&autosave_, &Autosave::stored,
                         [](quint64 edit) { tell("stored " + std::to_string(edit)); });
        if (!untitled_) open();
    }

    void step() {
        switch (random_() % 16) {
            case 0:
                if (untitled_) return edit();
                return must(autosave_.save(place()).has_value());
            case 1:
                return must(writeCase(folder_ / "single.json", document_.state()).has_value());
            case 2:
                return must(writeTextFile(folder_ / "table.csv", rows()).has_value());
            case 3:
                return report();
            case 4:
            case 5:
                if (document_.canUndo()) return made([this] { document_.undo(); });
                return edit();
            case 6:
                if (document_.canRedo()) return made([this] { document_.redo(); });
                return edit();
            default:
                return edit();
        }
    }
    void finish() {
        report();
        must(writeCase(folder_ / "single.json", document_.state()).has_value());
        must(writeTextFile(folder_ / "table.csv", rows()).has_value());
        if (!untitled_) must(autosave_.save(place()).has_value());
        autosave_.end();
    }

  private:
    std::filesystem::path place() const { return folder_ / "night.vestige"; }
    static void must(bool done) {
        if (!done) ::_exit(5);
    }
    void open() {
        const auto content = readCaseStore(place());
        must(content.has_value());
        if (!content->saved)  // killed before its first save was done
            return must(autosave_.save(place()).has_value());
        auto session = autosave_.opener().open(place());
        must(session->readOnly().empty());
        auto saved = readCase(place());
        must(saved.has_value());
        autosave_.follow(session);
        document_.replace(std::move(*saved));
        if (auto unsaved = session->takeRecovered())
            made([&] { document_.perform(restoreState(std::move(unsaved->state), "recover")); });
    }
    void edit() {
        made([this] { document_.perform(setCaseDetails("night", std::to_string(++value_), {})); });
    }
    /// What the edit will leave is known once it is done; it is told before its writer can have told of it,
    /// since that comes through the event loop.
    template <class Change>
    void made(const Change& change) {
        const auto before = document_.step();
        change();
        if (document_.step() != before)
            tell("made " + std::to_string(++count_) + " '" + document_.state().operatorName + "'");
    }
    std::string rows() {
        std::string text;
        for (int i = 0; i < 5000; ++i) text += document_.state().operatorName + ",1.25\n";
        return text + "end\n";
    }
    void report() {
        OutputFolder output(folder_ / "report");
        must(output.open().has_value());
        for (const char* name : {"measurements.csv", "screenshots/top.png", "manifest.json"})
            must(writeTextFile(output.path(name), rows()).has_value());
        must(output.commit().has_value());
    }

    std::filesystem::path folder_;
    std::mt19937 random_;
    long value_;
    bool untitled_;
    long count_ = 0;
    Document document_;
    Autosave autosave_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 6) return 2;
    QCoreApplication application(argc, argv);
    Worker worker(argv[1], static_cast<unsigned>(std::stoul(argv[2])), std::stol(argv[3]),
                  std::string(argv[5]) == "untitled");
    const long rounds = std::stol(argv[4]);
    long done = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        if (rounds > 0 && ++done > rounds) {
            worker.finish();
            QCoreApplication::quit();
        } else {
            worker.step();
        }
    });
    tell("begun");
    timer.start(0);
    return QCoreApplication::exec();
}

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <map>
#include <random>
#include <sstream>
#include <thread>

#include "core/base/AtomicFile.h"
#include "core/scene/CaseFile.h"
#include "core/scene/casefile/CaseText.h"
#include "core/scene/store/Autosaves.h"
#include "tests/support/TestPaths.h"

extern char** environ;

namespace vestige {
namespace {

namespace fs = std::filesystem;

/// A child that works on a case (Killed_child.cpp), and what it has told.
class Child {
  public:
    Child(const fs::path& folder, unsigned seed, long first, long rounds, bool untitled) {
        int ends[2];
        if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
        posix_spawn_file_actions_t actions;
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        std::vector<std::string> words{KILLED_CHILD,           folder.string(),
                                       std::to_string(seed),   std::to_string(first),
                                       std::to_string(rounds), untitled ? "untitled" : "case"};
        std::vector<char*> arguments;
        for (auto& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        if (::posix_spawn(&process_, KILLED_CHILD, &actions, nullptr, arguments.data(), environ) != 0)
            throw std::runtime_error("the child cannot be started");
        ::posix_spawn_file_actions_destroy(&actions);
        ::close(ends[1]);
        output_ = ends[0];
    }
    /// Waits for the first line, so that the moments are moments of work.
    void awaitBegin() {
        char c = 0;
        while (::read(output_, &c, 1) == 1 && c != '\n') {
        }
    }
    /// The exit status, once it ended.
    int finish(bool kill) {
        if (kill) ::kill(process_, SIGKILL);
        std::string text;
        char buffer[4096];
        for (ssize_t count = 0; (count = ::read(output_, buffer, sizeof buffer)) > 0;)
            text.append(buffer, static_cast<std::size_t>(count));
        int status = 0;
        ::waitpid(process_, &status, 0);
        ::close(output_);
        std::istringstream lines(text);
        std::string word;
        while (lines >> word) {
            long edit = 0;
            if (!(lines >> edit)) break;
            if (word == "stored") stored = edit;
            if (word == "made") lines >> made[edit];
        }
        return status;
    }

    std::map<long, std::string> made;  ///< operator's name after each edit
    long stored = 0;

  private:
    pid_t process_ = -1;
    int output_ = -1;
};

/// Whether the found state is that after the last stored edit or a later one.
bool holdsWhatWasStored(const Child& child, const std::string& found) {
    for (auto made = child.made.lower_bound(child.stored); made != child.made.end(); ++made)
        if (made->second == found) return true;
    return child.stored == 0;
}

/// The operator's name in the newest state that the store holds.
std::string operatorIn(const StoredCase& stored, const fs::path& folder) {
    const std::string& text = stored.drafts.empty() ? stored.saved.value() : stored.drafts.front();
    const auto scene = sceneFromText(text, folder.string(), folder);
    return scene ? "'" + scene->operatorName + "'" : scene.error().sentence();
}

/// All lines of the table are the same, and it ends.
bool isWhole(const fs::path& table) {
    const auto text = readTextFile(table);
    if (!text) return false;
    const std::string first = text->substr(0, text->find('\n') + 1);
    std::string whole;
    for (int i = 0; i < 5000; ++i) whole += first;
    return *text == whole + "end\n";
}

bool absentOrWhole(const fs::path& table) {
    return !fs::exists(table) || isWhole(table);
}

void checkOutputs(const fs::path& folder, int round) {
    EXPECT_TRUE(absentOrWhole(folder / "table.csv")) << round;
    if (fs::exists(folder / "report")) {
        const auto first = readTextFile(folder / "report/measurements.csv");
        for (const char* name : {"measurements.csv", "screenshots/top.png", "manifest.json"}) {
            EXPECT_TRUE(isWhole(folder / "report" / name)) << round << name;
            EXPECT_EQ(readTextFile(folder / "report" / name).value_or(""), first.value_or("none"))
                << round << ": files of two reports";
        }
    }
    EXPECT_TRUE(!fs::exists(folder / "single.json") || readCase(folder / "single.json")) << round;
}

int numberFrom(const char* variable, int otherwise) {
    const char* text = std::getenv(variable);
    return text ? std::atoi(text) : otherwise;
}

/// VESTIGE_KILLS: how many (200). VESTIGE_KILL_SECONDS: after how long to stop (45).
TEST(Killed, AtRandomMomentsNothingThatWasStoredIsLostAndNothingIsHalfWritten) {
    const test::TemporaryFolder folder;
    const int kills = numberFrom("VESTIGE_KILLS", 200);
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::seconds(numberFrom("VESTIGE_KILL_SECONDS", 45));
    std::mt19937 random(static_cast<unsigned>(numberFrom("VESTIGE_KILL_SEED", 20261127)));
    const Autosaves autosaves(folder / "autosave");
    long value = 0, stored = 0, made = 0;
    int round = 0;
    for (; round < kills && std::chrono::steady_clock::now() < end; ++round) {
        const bool untitled = round % 4 == 3;
        Child child(folder.path(), static_cast<unsigned>(random()), value, 0, untitled);
        if (round % 8 != 0) child.awaitBegin();  // else also while it starts
        ::usleep(static_cast<useconds_t>(random() % 200000));
        const int status = child.finish(true);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << status;
        value += 10000;
        stored += child.stored;
        made += static_cast<long>(child.made.size());
        if (untitled) {
            const auto left = autosaves.abandoned();
            if (child.stored > 0) {
                ASSERT_EQ(left.size(), 1u) << round;
                EXPECT_TRUE(holdsWhatWasStored(child, operatorIn(left[0].content, left[0].folder))) << round;
                EXPECT_TRUE(left[0].content.caseFile.empty());
            }
            for (const auto& one : left) Autosaves::remove(one.folder);
        } else if (fs::exists(folder / "night.vestige/case.db")) {
            const auto content = readCaseStore(folder / "night.vestige");
            ASSERT_TRUE(content) << round << ": " << content.error().sentence();
            if (content->saved) {
                ASSERT_TRUE(readCase(folder / "night.vestige")) << round;
                EXPECT_TRUE(holdsWhatWasStored(child, operatorIn(*content, folder / "night.vestige")))
                    << round << ": stored " << child.stored << ", found "
                    << operatorIn(*content, folder / "night.vestige");
            }
        }
        checkOutputs(folder.path(), round);
    }
    std::cout << round << " kills, " << made << " edits made, " << stored << " of them stored\n";
    EXPECT_GE(round, std::min(kills, 20));
    EXPECT_GT(stored, round / 2) << "too slow a machine to test anything";

    // One that is left alone clears away what the killed ones left.
    Child last(folder.path(), 1, value, 20, false);
    EXPECT_EQ(last.finish(false), 0);
    std::vector<std::string> hidden;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
        if (entry.path().filename().string().starts_with(".")) hidden.push_back(entry.path().string());
    EXPECT_TRUE(hidden.empty()) << hidden.front();
    EXPECT_FALSE(fs::exists(folder / "night.vestige/lock"));
    EXPECT_TRUE(fs::is_empty(folder / "autosave"));
    EXPECT_EQ(readCaseStore(folder / "night.vestige")->unsaved, 0);
}

TEST(Killed, AFolderFromBeforeThereWereDatabasesOpensWhereverItsFirstSaveIsKilled) {
    const std::string old = R"({"vestige":1,"operator":"before"})";
    std::mt19937 random(20261127);
    int saved = 0;
    // The first is let get through, which tells how long that takes here.
    std::chrono::microseconds whole{0};
    for (int round = 0; round < 60; ++round) {
        const test::TemporaryFolder folder;
        const fs::path place = folder / "night.vestige";
        ASSERT_TRUE(writeTextFile(place / "case.json", old));
        const auto begin = std::chrono::steady_clock::now();
        Child child(folder.path(), static_cast<unsigned>(random()), 0, 0, false);
        if (round == 0) {
            child.awaitBegin();
            whole = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() -
                                                                          begin);
        } else {
            std::this_thread::sleep_for(whole * (random() % 1000) / 900);
        }
        child.finish(true);
        const auto read = readCase(place);
        ASSERT_TRUE(read) << round << ": " << read.error().sentence();
        saved += read->operatorName != "before";
        EXPECT_TRUE(readTextFile(place / "case.json").value_or("") == old ||
                    readTextFile(place / "case-before-1.json").value_or("") == old)
            << round;
    }
    EXPECT_GT(saved, 0) << "the first at least";
    RecordProperty("killed before the save", 60 - saved);
}

}  // namespace
}  // namespace vestige

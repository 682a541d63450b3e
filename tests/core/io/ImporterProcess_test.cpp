#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "core/io/importer/ImporterProcess.h"
#include "core/io/importer/ImporterProtocol.h"
#include "tests/core/io/Clouds.h"
#include "tests/core/io/ZipText.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

using Seconds = std::chrono::duration<double>;

/// Puts a script in the place of vestige-import for as long as it lives.
class Impostor {
  public:
    explicit Impostor(const std::string& script) {
        writeBytes(folder_ / "import", "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(folder_ / "import", std::filesystem::perms::owner_all);
        ::setenv("VESTIGE_IMPORT", (folder_ / "import").c_str(), 1);
    }
    ~Impostor() { ::unsetenv("VESTIGE_IMPORT"); }

    std::string sentence(ImportRequest request = {}, const JobControl& control = {}) const {
        const ReadJob job("evidence.glb", control);
        const Status status = guarded("evidence.glb", [&]() -> Status {
            importScene(std::move(request), job, control);
            return {};
        });
        EXPECT_FALSE(status);
        return status ? "" : status.error().sentence();
    }

  private:
    TemporaryFolder folder_;
};

bool holds(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

std::string sent(const std::function<void(ImportSender&)>& what) {
    std::string stream;
    ImportSender sender([&](std::span<const std::byte> bytes) {
        stream.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    });
    what(sender);
    return stream;
}

Result<ImportedScene> received(std::string stream, std::uint64_t most = 1 << 20) {
    return guarded("a.glb", [&]() -> Result<ImportedScene> {
        const ByteInput input = [&](std::span<std::byte> bytes) {
            if (stream.size() < bytes.size()) throw ErrorException{{ErrorCode::input, "ended", "a.glb", {}}};
            std::memcpy(bytes.data(), stream.data(), bytes.size());
            stream.erase(0, bytes.size());
        };
        return receiveScene(input, most, ReadJob("a.glb", {}));
    });
}

}  // namespace

TEST(ImporterProcess, ACrashIsASentence) {
    const std::string sentence = Impostor("kill -SEGV $$").sentence();
    EXPECT_TRUE(holds(sentence, "evidence.glb: the separate reader of this format crashed")) << sentence;
    EXPECT_TRUE(holds(sentence, "signal 11")) << sentence;
}

TEST(ImporterProcess, AnEarlyEndAndGarbageAreSentences) {
    EXPECT_TRUE(holds(Impostor("exit 7").sentence(), "status 7"));
    EXPECT_TRUE(holds(Impostor("exit 12").sentence(), "needs more than 1024 MiB"));
    EXPECT_TRUE(holds(Impostor("echo this is no geometry at all").sentence(), "sent no geometry"));
    EXPECT_TRUE(holds(Impostor("printf VSTGIMP1").sentence(), "gave up"));
}

TEST(ImporterProcess, ARefusalWithoutWordsIsASentenceAndOneWithOrdersToTheTerminalIsClean) {
    const auto silent = received(sent([](ImportSender& sender) { sender.refusal("", ""); }));
    ASSERT_FALSE(silent);
    EXPECT_TRUE(holds(silent.error().message, "without saying why")) << silent.error().message;
    const auto loud =
        received(sent([](ImportSender& sender) { sender.refusal("\x1b[2Jbad", std::string(5000, 'x')); }));
    ASSERT_FALSE(loud);
    EXPECT_EQ(loud.error().message, "?[2Jbad");
    EXPECT_LT(loud.error().hint.size(), 1000);
}

TEST(ImporterProcess, AHangEndsAtItsTime) {
    ImportRequest request;
    request.time = std::chrono::seconds(1);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(holds(Impostor("exec /bin/sleep 100").sentence(std::move(request)), "takes more than 3 s"));
    EXPECT_LT(Seconds(std::chrono::steady_clock::now() - begin).count(), 10);
}

TEST(ImporterProcess, AHangBehindItsLastWordEndsAtItsTime) {
    ImportRequest request;
    request.time = std::chrono::seconds(1);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(
        holds(Impostor("exec /bin/sleep 100 >&-").sentence(std::move(request)), "takes more than 3 s"));
    EXPECT_LT(Seconds(std::chrono::steady_clock::now() - begin).count(), 10);
}

class ACancel : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(ImporterProcess, ACancel,
                         testing::Values("exec /bin/sleep 100", "exec /bin/sleep 100 >&-"));

TEST_P(ACancel, KillsItAtOnce) {
    const Impostor impostor(GetParam());
    const JobControl control;
    std::thread user([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        control.cancel();
    });
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(impostor.sentence({}, control), cancelledError().sentence());
    EXPECT_LT(Seconds(std::chrono::steady_clock::now() - begin).count(), 10);
    user.join();
}

TEST(ImporterProcess, GetsNothingButWhatItIsGiven) {
    // Descriptors 0 to 2 and the one file; an empty environment.
    const TemporaryFolder folder;
    writeBytes(folder / "given", "x");
    ImportRequest request;
    request.files.push_back(openForReading(folder / "given"));
    const std::string script =
        "ls /proc/$$/fd | wc -l >&2; test -e /proc/self/fd/3 && test ! -e /proc/self/fd/4 && test -z "
        "\"$HOME\" && exit 55; exit 1";
    EXPECT_TRUE(holds(Impostor(script).sentence(std::move(request)), "status 55"));
}

TEST(ImporterProcess, MeetsItsLimitOfMemory) {
    const TemporaryFolder folder;
    std::string mesh = "<object id=\"1\" type=\"model\"><mesh><vertices>";
    for (int i = 0; i < 200000; ++i) mesh += "<vertex x=\"" + std::to_string(i) + "\" y=\"0\" z=\"1\"/>";
    mesh += "</vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/></triangles></mesh></object>";
    const auto file = folder / "large.3mf";
    writeBytes(file, zipOf(threeMfParts(threeMfModel("meter", mesh, "<item objectid=\"1\"/>"))));
    ImportRequest request;
    request.format = "3mf";
    request.files.push_back(openForReading(file));
    request.memoryBytes = std::uint64_t{80} << 20;
    const ReadJob job(file, {});
    const Status status = guarded(file.string(), [&]() -> Status {
        importScene(std::move(request), job, {});
        return {};
    });
    ASSERT_FALSE(status);
    EXPECT_TRUE(holds(status.error().message, "needs more than 80 MiB of memory"))
        << status.error().sentence();
}

TEST(ImporterProtocol, EmptyBlocksAreNotFree) {
    const auto meshes = [](int count) {
        return sent([&](ImportSender& sender) {
            for (int i = 0; i < count; ++i) sender.mesh({});
            sender.end();
        });
    };
    EXPECT_TRUE(received(meshes(7000)));
    const Result<ImportedScene> many = received(meshes(9000));
    ASSERT_FALSE(many);
    EXPECT_TRUE(holds(many.error().message, "more than the file can hold")) << many.error().message;
}

TEST(ImporterProtocol, ArrivesAsItWasSentOrNotAtAll) {
    ImportedMesh mesh;
    mesh.vertices = {{1, 2, 3}, {4, 5, 6.25}, {7, 8, 9}};
    mesh.colors = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    mesh.triangles = {{0, 1, 2}};
    ImportedInstance place{0, Eigen::Affine3d(Eigen::Translation3d(1e6, 2, 3))};
    const std::string whole = sent([&](ImportSender& sender) {
        sender.warning("careful");
        sender.unit(0.0254);
        sender.mesh(mesh);
        sender.instances(std::span(&place, 1));
        sender.end();
    });
    const Result<ImportedScene> scene = received(whole);
    ASSERT_TRUE(scene) << scene.error().sentence();
    EXPECT_EQ(scene->warnings, std::vector<std::string>{"careful"});
    EXPECT_EQ(scene->metresPerUnit, 0.0254);
    ASSERT_EQ(scene->meshes.size(), 1);
    EXPECT_EQ(scene->meshes[0].vertices, mesh.vertices);
    EXPECT_EQ(scene->meshes[0].colors, mesh.colors);
    EXPECT_EQ(scene->meshes[0].triangles, mesh.triangles);
    ASSERT_EQ(scene->instances.size(), 1);
    EXPECT_EQ(scene->instances[0].fileFromMesh.matrix(), place.fileFromMesh.matrix());
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_FALSE(received(whole.substr(0, length)));
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ 4);
        EXPECT_FALSE(received(flipped)) << at;
    }
    EXPECT_FALSE(received(whole, 100)) << "more bytes than are allowed";
}

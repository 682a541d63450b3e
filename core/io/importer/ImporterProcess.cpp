#include "core/io/importer/ImporterProcess.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <utility>

#include "core/io/LoadEstimate.h"
#include "core/io/importer/ImporterProtocol.h"

namespace vestige {
namespace {

using Clock = std::chrono::steady_clock;

/// How soon a cancel is seen.
constexpr int kPollMilliseconds = 20;
/// Seconds on the wall for one of the processor: other programs want it too.
constexpr int kWall = 3;

[[noreturn]] void failSystem(const std::string& what, const std::string& place) {
    throw ErrorException{{ErrorCode::input, what, place, std::strerror(errno)}};
}

std::string megabytes(std::uint64_t bytes) {
    return std::to_string(bytes >> 20) + " MiB";
}

/// The files that the child starts with: 0 the request, 1 the pipe, 2 nothing, 3... those of the request.
class FileActions {
  public:
    FileActions() { ::posix_spawn_file_actions_init(&actions_); }
    ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    void give(int from, int as) { ::posix_spawn_file_actions_adddup2(&actions_, from, as); }
    void silence(int number) {
        ::posix_spawn_file_actions_addopen(&actions_, number, "/dev/null", O_WRONLY, 0);
    }
    void closeFrom(int number) { ::posix_spawn_file_actions_addclosefrom_np(&actions_, number); }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

/// Descriptors above those that the child's numbers may overwrite.
Descriptor movedUp(int number, const std::string& place) {
    Descriptor high(::fcntl(number, F_DUPFD_CLOEXEC, 256));
    if (high.number() < 0) failSystem("the separate reader cannot be given its files", place);
    return high;
}

class Child {
  public:
    Child(const ImportRequest& request, const ReadJob& job, const JobControl& control)
        : request_(request), job_(job), control_(control), deadline_(Clock::now() + kWall * request.time) {
        start();
    }
    ~Child() {
        if (process_ > 0) {
            ::kill(process_, SIGKILL);
            wait();
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Exactly these bytes of what the child writes.
    void read(std::span<std::byte> bytes) {
        while (!bytes.empty()) {
            waitForOutput();
            const ssize_t got = ::read(output_.number(), bytes.data(), bytes.size());
            if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
            if (got <= 0) refuseEnd();
            bytes = bytes.subspan(static_cast<std::size_t>(got));
        }
    }

  private:
    void start() {
        const std::filesystem::path program = importerProgram();
        if (program.empty())
            job_.refuse("the program vestige-import, which reads this format, is missing",
                        "vestige-import beside this program");
        int ends[2];
        if (::pipe2(ends, O_CLOEXEC) != 0) failSystem("the separate reader cannot start", job_.place());
        output_ = Descriptor(ends[0]);
        const Descriptor input(ends[1]);
        std::vector<Descriptor> given;
        given.push_back(movedUp(fileInMemory(request_.request).number(), job_.place()));
        given.push_back(movedUp(input.number(), job_.place()));
        for (const Descriptor& file : request_.files) given.push_back(movedUp(file.number(), job_.place()));
        FileActions actions;
        for (std::size_t i = 0; i < given.size(); ++i)
            actions.give(given[i].number(), static_cast<int>(i < 2 ? i : i + 1));
        actions.silence(2);
        actions.closeFrom(static_cast<int>(given.size()) + 1);
        std::vector<std::string> words{program.string(), request_.format,
                                       std::to_string(request_.memoryBytes),
                                       std::to_string(request_.time.count())};
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        char* environment[] = {nullptr};
        const int problem =
            ::posix_spawn(&process_, program.c_str(), actions.get(), nullptr, arguments.data(), environment);
        if (problem != 0) {
            process_ = 0;
            errno = problem;
            failSystem("the separate reader " + program.string() + " cannot start", job_.place());
        }
    }

    /// Throws when the user cancels or the time is up.
    void checkTime() const {
        if (control_.cancelled()) throw ErrorException{cancelledError()};
        if (Clock::now() > deadline_)
            job_.refuse("reading takes more than " + std::to_string((kWall * request_.time).count()) + " s",
                        "a file that its reader is done with in that time");
    }

    void waitForOutput() {
        for (;;) {
            checkTime();
            pollfd entry{output_.number(), POLLIN, 0};
            const int ready = ::poll(&entry, 1, kPollMilliseconds);
            if (ready > 0) return;
        }
    }

    /// A child that has closed its output need not have ended.
    int waitForEnd() {
        constexpr std::chrono::milliseconds kPause(1);
        int status = 0;
        while (::waitpid(process_, &status, WNOHANG) != process_) {
            checkTime();
            std::this_thread::sleep_for(kPause);
        }
        process_ = 0;
        return status;
    }

    int wait() {
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = 0;
        return status;
    }

    /// The pipe ended before the geometry did: why?
    [[noreturn]] void refuseEnd() {
        const int status = waitForEnd();
        const std::string expected = "a whole and valid file of this format";
        if (WIFEXITED(status) && WEXITSTATUS(status) == kImporterOutOfMemory)
            job_.refuse("reading needs more than " + megabytes(request_.memoryBytes) + " of memory",
                        expected);
        if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
            job_.refuse(
                "reading takes more than " + std::to_string(request_.time.count()) + " s of the processor",
                expected);
        if (WIFSIGNALED(status))
            job_.refuse("the separate reader of this format crashed on the file (signal " +
                            std::to_string(WTERMSIG(status)) + ")",
                        expected);
        job_.refuse("the separate reader of this format gave up on the file (status " +
                        std::to_string(WEXITSTATUS(status)) + ")",
                    expected);
    }

    const ImportRequest& request_;
    const ReadJob& job_;
    const JobControl& control_;
    Clock::time_point deadline_;
    Descriptor output_;
    pid_t process_ = 0;
};

}  // namespace

Descriptor openForReading(const std::filesystem::path& file) {
    Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat facts {};
    if (opened.number() < 0 || ::fstat(opened.number(), &facts) != 0)
        failSystem("the file cannot be opened for reading", file.string());
    if (!S_ISREG(facts.st_mode))
        throw ErrorException{
            {ErrorCode::input, "this is no regular file", file.string(), "expected: a file"}};
    return opened;
}

Descriptor fileInMemory(std::string_view content) {
    Descriptor memory(::memfd_create("vestige", MFD_CLOEXEC));
    if (memory.number() < 0) failSystem("a file in memory cannot be made", {});
    while (!content.empty()) {
        const ssize_t wrote = ::write(memory.number(), content.data(), content.size());
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) failSystem("a file in memory cannot be written", {});
        content.remove_prefix(static_cast<std::size_t>(wrote));
    }
    ::lseek(memory.number(), 0, SEEK_SET);
    return memory;
}

std::uint64_t importMemoryFor(std::uint64_t fileBytes) {
    constexpr std::uint64_t kFloor = std::uint64_t{1} << 30;
    constexpr std::uint64_t kTimes = 24;
    const std::uint64_t wanted = kFloor + kTimes * std::min(fileBytes, std::uint64_t{1} << 50);
    return std::max(kFloor, std::min(wanted, availableMemory()));
}

std::chrono::seconds importTimeFor(std::uint64_t fileBytes) {
    return std::chrono::seconds(10 + std::min<std::uint64_t>(fileBytes / 1'000'000, 36'000));
}

std::filesystem::path importerProgram() {
    namespace fs = std::filesystem;
    std::error_code problem;
    std::vector<fs::path> places;
    if (const char* chosen = std::getenv("VESTIGE_IMPORT")) places.emplace_back(chosen);
    const fs::path here = fs::read_symlink("/proc/self/exe", problem).parent_path();
    if (!problem) {
        places.push_back(here / "vestige-import");
        places.push_back(here.parent_path() / "libexec" / "vestige" / "vestige-import");
    }
    for (const fs::path& place : places)
        if (fs::is_regular_file(place, problem) && ::access(place.c_str(), X_OK) == 0) return place;
    return {};
}

ImportedScene importScene(ImportRequest request, const ReadJob& job, const JobControl& control) {
    Child child(request, job, control);
    const ByteInput input = [&](std::span<std::byte> bytes) { child.read(bytes); };
    return receiveScene(input, request.resultBytes, job);
}

}  // namespace vestige

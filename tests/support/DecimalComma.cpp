#include "tests/support/DecimalComma.h"

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "tests/support/TestPaths.h"

namespace vestige::test {
namespace {

constexpr const char* kName = "de_DE.UTF-8";

}  // namespace

DecimalComma::DecimalComma()
    : folder_(std::make_unique<TemporaryFolder>()), cBefore_(std::setlocale(LC_ALL, nullptr)) {
    const std::string command =
        "localedef -i de_DE -f UTF-8 '" + (*folder_ / kName).string() + "' >/dev/null 2>&1";
    // It warns, and then says 1, of what other systems would not understand.
    static_cast<void>(std::system(command.c_str()));
    ::setenv("LOCPATH", folder_->path().c_str(), 1);
    try {
        std::locale::global(std::locale(kName));  // the C library's, too
    } catch (const std::runtime_error&) {
        return;
    }
    char text[16];
    std::snprintf(text, sizeof text, "%.1f", 1.5);
    works_ = std::string(text) == "1,5";
}

DecimalComma::~DecimalComma() {
    std::locale::global(before_);
    std::setlocale(LC_ALL, cBefore_.c_str());
    ::unsetenv("LOCPATH");
}

}  // namespace vestige::test

#pragma once

#include <locale>
#include <memory>
#include <string>

namespace vestige::test {

class TemporaryFolder;

/// German numbers for the C and C++ libraries of this process while it lives: 1,5 and 1.000. The locale is
/// made with localedef in a folder of its own; where that does not work, works() is false and nothing
/// changes.
class DecimalComma {
  public:
    DecimalComma();
    ~DecimalComma();
    DecimalComma(const DecimalComma&) = delete;
    DecimalComma& operator=(const DecimalComma&) = delete;
    bool works() const { return works_; }

  private:
    std::unique_ptr<TemporaryFolder> folder_;
    std::locale before_;
    std::string cBefore_;
    bool works_ = false;
};

}  // namespace vestige::test

#pragma once

namespace vestige {

/// An open file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    /// Negative where there is none.
    int number() const { return number_; }

  private:
    int number_;
};

}  // namespace vestige

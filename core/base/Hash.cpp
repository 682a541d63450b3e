#include "core/base/Hash.h"

#include <openssl/evp.h>

#include <fstream>
#include <vector>

namespace vestige {

struct Sha256::State {
    EVP_MD_CTX* context = EVP_MD_CTX_new();
    State() { EVP_DigestInit_ex(context, EVP_sha256(), nullptr); }
    ~State() { EVP_MD_CTX_free(context); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

Sha256::Sha256() : state_(std::make_unique<State>()) {}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::span<const std::byte> bytes) {
    EVP_DigestUpdate(state_->context, bytes.data(), bytes.size());
}

void Sha256::add(const std::string& text) {
    add(std::as_bytes(std::span(text)));
}

std::array<std::uint8_t, 32> Sha256::digest() {
    std::array<std::uint8_t, 32> bytes{};
    EVP_DigestFinal_ex(state_->context, bytes.data(), nullptr);
    return bytes;
}

std::string Sha256::hex() {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : digest()) {
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

Result<std::string> sha256OfFile(const std::filesystem::path& file, const JobControl& control) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        return fail(ErrorCode::input, "the file cannot be opened for reading", file.string());
    Sha256 sha;
    std::vector<char> buffer(1 << 20);
    while (stream) {
        if (control.cancelled()) return fail(cancelledError());
        stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        sha.add(std::as_bytes(std::span(buffer.data(), static_cast<std::size_t>(stream.gcount()))));
    }
    if (stream.bad()) return fail(ErrorCode::input, "reading stopped with a device error", file.string());
    return sha.hex();
}

}  // namespace vestige

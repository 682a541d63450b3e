#include "core/io/WktTree.h"

#include <algorithm>

#include "core/base/Numbers.h"
#include "core/io/TextScanner.h"

namespace vestige {
namespace {

constexpr int kDeepest = 32;

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    bool node(WktNode& node, int depth) {
        node.keyword = word();
        if (node.keyword.empty() || depth > kDeepest || !(take('[') || take('('))) return false;
        do {
            if (take('"')) {
                const std::size_t end = text_.find('"');
                if (end == std::string_view::npos) return false;
                node.values.push_back(text_.substr(0, end));
                text_.remove_prefix(end + 1);
                continue;
            }
            const std::string_view before = text_;
            const std::string_view next = word();
            if (next.empty()) return false;
            if (peek() == '[' || peek() == '(') {
                text_ = before;
                if (!this->node(node.children.emplace_back(), depth + 1)) return false;
            } else {
                node.values.push_back(next);
            }
        } while (take(','));
        return take(']') || take(')');
    }

  private:
    char peek() {
        text_ = trimmed(text_);
        return text_.empty() ? '\0' : text_.front();
    }
    bool take(char c) {
        if (peek() != c) return false;
        text_.remove_prefix(1);
        return true;
    }
    std::string_view word() {
        peek();
        const std::size_t end = std::min(text_.find_first_of("[](),\" \t\r\n"), text_.size());
        const std::string_view found = text_.substr(0, end);
        text_.remove_prefix(end);
        return found;
    }

    std::string_view text_;
};

}  // namespace

bool WktNode::is(std::string_view upperKeyword) const {
    return std::equal(keyword.begin(), keyword.end(), upperKeyword.begin(), upperKeyword.end(),
                      [](char a, char b) { return upper(a) == b; });
}

const WktNode* WktNode::child(std::string_view upperKeyword) const {
    for (const WktNode& one : children)
        if (one.is(upperKeyword)) return &one;
    return nullptr;
}

std::optional<double> WktNode::number(std::size_t place) const {
    return place < values.size() ? parseReal(values[place]) : std::nullopt;
}

std::optional<WktNode> parseWkt(std::string_view text) {
    WktNode root;
    if (!Parser(text).node(root, 0)) return std::nullopt;
    return root;
}

}  // namespace vestige

// Edit distance and suggestions.
#include "data/nearest.h"

#include <algorithm>
#include <vector>

namespace cairn::scripting {
namespace {

/// "fill_circle" and "fillCircle" are "fill" and "circle". "get" says nothing: getters are nouns here.
std::vector<std::string> words_in(std::string_view name) {
    std::vector<std::string> words;
    bool begins = true;
    for (const char c : name) {
        const bool is_upper = c >= 'A' && c <= 'Z';
        if (c == '_') {
            begins = true;
            continue;
        }
        if (begins || is_upper) words.emplace_back();
        words.back() += is_upper ? static_cast<char>(c + ('a' - 'A')) : c;
        begins = false;
    }
    std::erase(words, "get");
    return words;
}

/// How much more two names share than they differ in, in words; 0 if what they share is less than half of
/// the candidate.
int kinship(const std::vector<std::string>& wanted, const std::vector<std::string>& candidate) {
    const auto shared = std::count_if(candidate.begin(), candidate.end(), [&](const std::string& word) {
        return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
    });
    if (shared == 0 || 2 * shared < static_cast<std::ptrdiff_t>(candidate.size())) return 0;
    constexpr int kMostWords = 100;
    return kMostWords + static_cast<int>(4 * shared) - static_cast<int>(wanted.size() + candidate.size());
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<int> table((a.size() + 1) * width);
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return table[i * width + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int replace = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, replace});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
            }
        }
    }
    return at(a.size(), b.size());
}

std::string_view nearest(std::string_view word, std::span<const std::string> candidates) {
    constexpr std::size_t kLongestWord =
        64;  // longer ones are no typing slips, and the table grows with the square
    if (word.size() > kLongestWord) return {};
    const std::vector<std::string> words = words_in(word);
    for (const std::string& candidate : candidates) {
        if (!words.empty() && words_in(candidate) == words) return candidate;
    }
    std::string_view best;
    int best_distance = static_cast<int>(std::max<std::size_t>(word.size(), 3) + 2) / 3 + 1;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > kLongestWord) continue;
        const int distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    if (!best.empty()) return best;
    int best_kinship = 0;
    for (const std::string& candidate : candidates) {
        const int shared = kinship(words, words_in(candidate));
        if (shared <= best_kinship) continue;
        best = candidate;
        best_kinship = shared;
    }
    return best;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
    constexpr std::size_t kMostListed = 24;
    std::string out;
    if (const std::string_view best = nearest(word, candidates); !best.empty()) {
        out += "; did you mean \"" + std::string(best) + "\"?";
    }
    if (candidates.empty() || candidates.size() > kMostListed) return out;
    out += " (";
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (i > 0) out += ", ";
        out += candidates[i];
    }
    return out + ')';
}

}  // namespace cairn::scripting

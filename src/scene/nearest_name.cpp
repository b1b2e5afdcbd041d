#include "rt/scene/render_options.h"

#include <algorithm>

namespace rt {

namespace {

/// Edits (insert, delete, replace, swap of neighbours) between two words: the optimal string
/// alignment distance (Boytsov, Indexing Methods for Approximate Dictionary Searching, 2011).
std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(beforeLast, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
    }
    return row[b.size()];
}

}  // namespace

std::string nearestName(const std::string& word, const std::vector<std::string>& known) {
    if (word.size() < 2) return "";
    const std::size_t most = std::max<std::size_t>(1, word.size() / 3);
    std::size_t fewest = most + 1;
    std::string nearest;
    for (const std::string& candidate : known) {
        const std::size_t longer = std::max(word.size(), candidate.size());
        const std::size_t shorter = std::min(word.size(), candidate.size());
        if (longer - shorter >= fewest) continue;
        const std::size_t edits = editDistance(word, candidate);
        if (edits < fewest) {
            fewest = edits;
            nearest = candidate;
        }
    }
    return nearest;
}

}  // namespace rt

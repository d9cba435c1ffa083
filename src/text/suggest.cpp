#include "text/suggest.hpp"

#include <algorithm>

#include "text/capitals.hpp"

namespace blocks::text {
namespace {

/// Returns the optimal string alignment distance. Edits are: insert, delete, replace,
/// swap neighbours.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1),
      current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    previous[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      current[j] =
          std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], before[j - 2] + 1);
      }
    }
    before.swap(previous);
    previous.swap(current);
  }
  return previous[b.size()];
}

}  // namespace

std::string suggest(std::string_view word,
                    const std::vector<std::string_view>& candidates) {
  constexpr std::size_t longest = 24;  // no card name is longer
  if (word.empty() || word.size() > longest) {
    return {};
  }
  const std::string wanted = capitals(word);
  std::string best;
  long min = 0;
  for (const std::string_view candidate : candidates) {
    const std::string name = capitals(candidate);
    const std::size_t distance = edit_distance(wanted, name);
    const std::size_t shorter = std::min(wanted.size(), name.size());
    const bool near = distance <= std::max<std::size_t>(1, shorter / 3);
    const bool begins =
        shorter >= 3 && wanted.compare(0, shorter, name, 0, shorter) == 0;
    if (!near && !begins) {
      continue;
    }
    // DAMP for DAMPING ranks before every near miss, such as DUMP, and SETVELOCITY for
    // SETVEL after it.
    const bool shortened = begins && shorter == wanted.size();
    const long rank = shortened ? 0 : near ? 1 : 2;
    // Each letter of a common beginning cancels half an edit. So FRICTION suggests
    // FRICTN, although FRACTION is fewer edits away.
    const auto same =
        std::mismatch(wanted.begin(), wanted.begin() + static_cast<long>(shorter),
                      name.begin())
            .first -
        wanted.begin();
    const long score =
        2 * static_cast<long>(distance) - same + rank * static_cast<long>(4 * longest);
    if (best.empty() || score < min) {
      min = score;
      best = candidate;
    }
  }
  return best;
}

}  // namespace blocks::text

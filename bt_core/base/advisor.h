// The nearest right names for a whole file: one of very many unknown names gets no advice any more
// once looking for it has taken about a second, where it could take minutes.
#ifndef COPPICE_BT_CORE_BASE_ADVISOR_H_
#define COPPICE_BT_CORE_BASE_ADVISOR_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"

namespace coppice {

/// One for each file that is read. `name_of` gives the name of each candidate. One thread.
class Advisor {
 public:
  /// As NearestName.
  template <class Candidates, class NameOf>
  std::string Nearest(std::string_view name, const Candidates& candidates, NameOf name_of) {
    if (!MayCompare(name, candidates.size())) return {};
    std::vector<std::string> names;
    for (const auto& candidate : candidates) names.push_back(name_of(candidate));
    return NearestName(name, names);
  }

  /// As DidYouMean.
  template <class Candidates, class NameOf>
  std::string Advise(std::string_view name, const Candidates& candidates, NameOf name_of) {
    const std::string nearest = Nearest(name, candidates, name_of);
    return nearest.empty() ? nearest : DidYouMean(name, {nearest});
  }

 private:
  bool MayCompare(std::string_view name, std::size_t candidates);

  std::size_t compared_ = 0;  // letters with letters, about
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_ADVISOR_H_

// Where the parts of the compiler report to. A tree that is used as a SubTree in fifty places is
// compiled fifty times; what is wrong with it is said once.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_PROBLEMS_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_PROBLEMS_H_

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "bt_core/base/advisor.h"
#include "bt_core/base/diagnostic.h"
#include "bt_core/engine/compile/sibling_files.h"
#include "bt_core/model/document.h"

namespace coppice {

class Problems {
 public:
  explicit Problems(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// `offset` is in bytes from the start of the document's text.
  void Add(Severity severity, const Document& document, std::uint32_t offset, std::string message,
           std::string hint = {}, ProblemSubject about = {});
  void Error(const Document& document, std::uint32_t offset, std::string message,
             std::string hint = {}, ProblemSubject about = {}) {
    Add(Severity::kError, document, offset, std::move(message), std::move(hint), std::move(about));
  }
  void Warning(const Document& document, std::uint32_t offset, std::string message,
               std::string hint = {}, ProblemSubject about = {}) {
    Add(Severity::kWarning, document, offset, std::move(message), std::move(hint),
        std::move(about));
  }

  /// True the first time: for what is said once and not in every place.
  bool IsFirst(const std::string& topic) { return topics_.insert(topic).second; }

  /// As NearestName and DidYouMean; see Advisor.
  template <class Candidates, class NameOf>
  std::string Nearest(std::string_view name, const Candidates& candidates, NameOf name_of) {
    return advisor_.Nearest(name, candidates, name_of);
  }
  template <class Candidates, class NameOf>
  std::string Advise(std::string_view name, const Candidates& candidates, NameOf name_of) {
    return advisor_.Advise(name, candidates, name_of);
  }

  bool has_errors() const { return diagnostics_.has_errors(); }

  /// For advice about what is missing.
  SiblingFiles& siblings() { return siblings_; }

 private:
  Diagnostics& diagnostics_;
  Advisor advisor_;
  std::set<std::tuple<const Document*, std::uint32_t, std::string>> known_;
  std::set<std::string> topics_;
  SiblingFiles siblings_;
};

/// The text in double quotes.
std::string Quoted(std::string_view text);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_COMPILER_PROBLEMS_H_

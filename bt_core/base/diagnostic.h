// What is wrong with a user's file, and where.
//
// Loading and checking never throw and never stop at the first problem: they add Diagnostics to a
// list and the caller looks at HasErrors(). A diagnostic names the place in the user's own text,
// says what was expected, and gives the nearest right name as a hint:
//
//   patrol.xml:12:9: error: unknown node type "Sequense" (did you mean "Sequence"?)
#ifndef COPPICE_BT_CORE_BASE_DIAGNOSTIC_H_
#define COPPICE_BT_CORE_BASE_DIAGNOSTIC_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace coppice {

/// A place in a text file. Lines and columns count from 1, columns in bytes; 0 means unknown.
struct SourceLocation {
  std::string file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

enum class Severity : std::uint8_t { kWarning, kError };

/// Problems that programs recognise, to mend them or to tell them in their own way; all others need
/// nobody but their reader.
enum class ProblemKind : std::uint8_t {
  kOther,
  kNoModel,      ///< of this type: nothing says which ports it has
  kMissingPort,  ///< this one is needed
  kUnknownPort,  ///< the type has none of this name
  kEmptyTree,    ///< of this ID
  kInScript,     ///< the place lies within a script: what is meant stands for one word of it
  kCannotWrite,  ///< the hint tells why
  kOldFormat,    ///< of the file, or it does not say its format
};

struct ProblemSubject {
  ProblemKind kind = ProblemKind::kOther;
  std::string name;  ///< of the port, type or tree
};

struct Diagnostic {
  Severity severity = Severity::kError;
  SourceLocation where;
  std::string message;
  std::string hint;  ///< may be empty; for example: did you mean "Sequence"?
  ProblemSubject about = {};
};

/// "file:line:column: error: message (hint)", leaving out what is unknown.
std::string ToString(const Diagnostic& diagnostic);

/// The problems found so far, in the order of finding: the first 10 000 errors and as many
/// warnings. Of what comes after them it is only said that there is more.
class Diagnostics {
 public:
  static constexpr int kMostOfAKind = 10'000;

  void Error(SourceLocation where, std::string message, std::string hint = {},
             ProblemSubject about = {});
  void Warning(SourceLocation where, std::string message, std::string hint = {},
               ProblemSubject about = {});

  /// Adds all of the other list.
  void Append(const Diagnostics& other);

  bool has_errors() const { return errors_ > 0; }
  const std::vector<Diagnostic>& all() const { return all_; }

  /// One line per diagnostic.
  std::string ToString() const;

 private:
  void Add(Diagnostic diagnostic);

  std::vector<Diagnostic> all_;
  int errors_ = 0;    // also those that were not kept
  int warnings_ = 0;  // likewise
};

/// The candidate that is nearest to a misspelt name, or empty if none is near. Compares without
/// case; near means an edit distance of at most a third of the name's length (at least one).
std::string NearestName(std::string_view name, const std::vector<std::string>& candidates);

/// `did you mean "X"?` for the nearest candidate, or empty.
std::string DidYouMean(std::string_view name, const std::vector<std::string>& candidates);

/// The name that such a hint gives; empty if it gives none.
std::string NameMeant(std::string_view hint);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_DIAGNOSTIC_H_

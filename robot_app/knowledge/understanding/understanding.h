// From what somebody says to what is wanted: an intent with its slots, or why not.
//
//   const Understander english(table, words, Names(database), Language::kEnglish);
//   const Understanding heard = english.Understand("wher is the libary");
//   // kUnderstood: find_place, place = library
//
// Each row of the table is tried: phrases that are in the utterance and names for its slots speak
// for it, words that it leaves unexplained against it. The best row is taken if enough speaks for
// it; what stays unexplained beside it makes the utterance unknown, so that nobody is sent to the
// library who asked for the one in Paris. Takes any bytes and ends in a few milliseconds.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_UNDERSTANDING_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_UNDERSTANDING_H_

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "robot_app/knowledge/understanding/intent_table.h"
#include "robot_app/knowledge/understanding/name_index.h"

namespace coppice::robot::knowledge {

/// A name that fits worse is asked back.
inline constexpr double kSureName = 0.72;
/// Of the best name's value: one of so much may be meant as well.
inline constexpr double kAsGoodName = 0.93;

struct Slot {
  Kind kind = Kind::kPlace;
  std::string subject;

  bool operator==(const Slot& other) const {
    return kind == other.kind && subject == other.subject;
  }
};

/// What somebody wants, by voice or by touch.
struct Request {
  Intent intent = Intent::kHelp;
  std::vector<Slot> slots;

  /// Null if it is not filled.
  const Slot* Find(Kind kind) const;

  bool operator==(const Request& other) const {
    return intent == other.intent && slots == other.slots;
  }
};

enum class Verdict : std::uint8_t {
  kUnderstood,
  kAmbiguous,  ///< one of the choices is meant, if any
  kMissing,    ///< the intent is clear; a slot that it needs was not named
  kUnknown,    ///< refused
};

struct Understanding {
  Verdict verdict = Verdict::kUnknown;
  Request request;            ///< of kAmbiguous and kMissing without the slot in question
  std::vector<Slot> choices;  ///< one to three, the likeliest first
  std::string unknown;        ///< the words that nobody knows; may be empty
};

/// Immutable; any thread.
class Understander {
 public:
  /// `table` and `words` must outlive this.
  Understander(const IntentTable& table, const LanguageWords& words, const std::vector<Name>& names,
               Language language);

  Understanding Understand(std::string_view text) const;
  /// The names of these kinds in an answer to "which one?", the best first.
  std::vector<Candidate> FindNames(std::string_view text, const std::vector<Kind>& kinds) const;

 private:
  struct Reading {
    const IntentRow* row = nullptr;
    double score = 0;
    std::vector<const Candidate*> slots;   // the one that is needed comes first
    std::vector<const Candidate*> rivals;  // of the one that is needed, itself included
    WordSet cues, needed, explained;
    bool is_missing = false;
  };

  /// `needed`: only that one is taken for what the row needs; nothing: the best one.
  Reading Read(const IntentRow& row, const Utterance& utterance,
               const std::vector<Candidate>& candidates,
               std::optional<Kind> needed = std::nullopt) const;
  double FindCues(const IntentRow& row, const Utterance& utterance, WordSet& cues) const;
  bool Suits(const IntentRow& row, const Utterance& utterance, const Candidate& candidate) const;
  Utterance Hear(std::string_view text) const;
  bool IsOfName(const WordSet& left, const WordSet& name, const Utterance& utterance) const;
  Understanding Judge(const Reading& reading, const Utterance& utterance) const;

  const IntentTable& table_;
  const LanguageWords& words_;
  Language language_;
  NameIndex index_;
  std::set<std::string> vocabulary_;  // of all phrases
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_UNDERSTANDING_H_

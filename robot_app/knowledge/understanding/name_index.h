// All names, ready to be found in what somebody has said although it is misspelt, misheard or only
// a part of the name.
//
// A name fits as well as its words do (word_similarity.h), in their order, each weighted by how few
// subjects it belongs to: in "room 103" the number counts and the room hardly. Of the names that
// overlap the one that explains more of the utterance is better.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_NAME_INDEX_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_NAME_INDEX_H_

#include <string>
#include <vector>

#include "robot_app/knowledge/store/language.h"
#include "robot_app/knowledge/understanding/utterance.h"

namespace coppice::robot::knowledge {

/// A subject that an utterance may name.
struct Candidate {
  Kind kind = Kind::kPlace;
  std::string subject;
  double fit = 0;    ///< of its best name: 1, it is there as it is written; 0.5, half of it
  double value = 0;  ///< fit and how much of the utterance it explains: for comparing candidates
  WordSet words;     ///< of the utterance
};

/// Immutable; any thread.
class NameIndex {
 public:
  /// Names that fit worse are not found.
  static constexpr double kLeastFit = 0.5;

  /// Names of lines are also found as the language says them.
  NameIndex(const std::vector<Name>& names, const LanguageWords& language, Language spoken);

  /// One for each subject that fits, the best ones first.
  std::vector<Candidate> Find(const Utterance& utterance) const;

 private:
  struct Word {
    SoundingWord word;
    double weight = 1;
    bool is_filler = false;
  };
  struct Entry {
    Kind kind = Kind::kPlace;
    int subject = 0;
    bool is_foreign = false;  // of another language
    std::vector<int> words;   // of words_
  };
  struct Match {
    double fit = 0;
    WordSet words;
  };
  using Table = std::vector<std::vector<double>>;  // similarity [word of the utterance][of words_]

  void Add(const Name& name, const std::string& text, const LanguageWords& language,
           bool is_foreign);
  int WordId(const std::string& text);
  void Weigh(const LanguageWords& language);
  double WeightOf(const Entry& entry, std::size_t word) const;
  Table SimilarityOf(const std::vector<SoundingWord>& words, const WordSet& exact) const;
  Match BestMatch(const Entry& entry, const WordSet& content, const Table& single,
                  const Table& joined) const;

  std::vector<Word> words_;
  std::vector<std::pair<Kind, std::string>> subjects_;
  std::vector<Entry> entries_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_NAME_INDEX_H_

// How a word sounds, as a short code: words of the same code sound alike. Words are folded
// (folded_text.h); digits and spaces have no sound.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_PHONETICS_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_PHONETICS_H_

#include <string>
#include <string_view>

namespace coppice::robot::knowledge {

/// German: H. J. Postel, "Die Koelner Phonetik", IBM-Nachrichten 19 (1969). "meier", "maier" and
/// "mayer" are "67".
std::string ColognePhonetics(std::string_view word);

/// A word may be spoken in two ways.
struct MetaphoneCodes {
  std::string primary, other;
};

/// English: L. Philips, "The Double Metaphone Search Algorithm", C/C++ Users Journal 18 (2000),
/// its rules for English words and for the German and Slavic names among them. "smith" is "SM0",
/// otherwise "XMT", as "schmidt".
MetaphoneCodes DoubleMetaphone(std::string_view word);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_PHONETICS_H_

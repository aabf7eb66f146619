// Between the characters of an attribute value and the bytes that stand for them in XML text.
//
//   DecodeXml("a &lt; 3")            -> a < 3
//   EscapeXmlValue("a < \"b\"", '"') -> a &lt; &quot;b&quot;
//
// The engine decodes values itself: tinyxml2 9 loses an '&' that stands for itself behind a
// reference ("a &lt; 3 && b" loses both), and scripts are written like that. What is decoded are
// the five named references, numeric references of valid code points, and line ends: CR LF, LF CR
// and CR are one LF (XML 1.0 2.11, as tinyxml2 reads it). Everything else stands for itself.
#ifndef COPPICE_BT_CORE_MODEL_XML_TEXT_H_
#define COPPICE_BT_CORE_MODEL_XML_TEXT_H_

#include <cstddef>
#include <string>
#include <string_view>

namespace coppice {

/// What tinyxml2 takes for a blank.
inline constexpr const char* kXmlBlanks = " \t\n\v\f\r";

/// True if decoding changes the text.
bool NeedsDecoding(std::string_view raw);

/// The characters that the raw text stands for.
std::string DecodeXml(std::string_view raw);

/// Where in the raw text the character at `decoded_offset` of the decoded text begins; the end of
/// the raw text for what lies behind.
std::size_t RawOffset(std::string_view raw, std::size_t decoded_offset);

/// The length of the reference, such as &lt; or &#x41;, at the start of the text; 0 if there is
/// none.
std::size_t ReferenceLength(std::string_view raw);

/// The value as it must stand between two `quote`s ('"' or '\''). Line ends and tabs become numeric
/// references, because strict XML parsers read them as blanks.
std::string EscapeXmlValue(std::string_view value, char quote);

/// The length of the name of an element or attribute at the start of the text; 0 if there is none.
std::size_t NameLength(std::string_view text);

/// True if an element or attribute can have that name. Names beyond ASCII are fine.
bool IsXmlName(std::string_view name);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_XML_TEXT_H_

// XML text cut into pieces: text, tags, comments and so on, each with its place. No parser: it does
// not check anything. It finds where the elements of a text end that tinyxml2 has accepted, and
// where the first mistake lies in a text that tinyxml2 has refused.
#ifndef COPPICE_BT_CORE_MODEL_MARKUP_H_
#define COPPICE_BT_CORE_MODEL_MARKUP_H_

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace coppice {

enum class MarkupKind : std::uint8_t {
  kText,
  kComment,        ///< <!-- -->
  kCharacterData,  ///< <![CDATA[ ]]>
  kInstruction,    ///< <? ?>
  kDocumentType,   ///< <! >
  kTag             ///< start tag, end tag or self-closing tag
};

struct Markup {
  MarkupKind kind = MarkupKind::kText;
  std::size_t begin = 0;
  std::size_t end = 0;    ///< behind the last byte; the end of the text if it is not closed
  bool is_closed = true;  ///< false: the text ends before --> ]]> ?> or >
};

/// The piece that begins at `at`, which lies in the text. A '>' inside quotes does not end a tag.
Markup ReadMarkup(std::string_view text, std::size_t at);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_MARKUP_H_

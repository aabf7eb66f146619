// What would make a problem go away, where that can be said: a button beside the message.
#ifndef COPPICE_EDITOR_DOCUMENT_FIXES_H_
#define COPPICE_EDITOR_DOCUMENT_FIXES_H_

#include <string>
#include <vector>

#include "bt_core/model/document.h"

namespace coppice::editor {

struct Fix {
  std::string title;    ///< "SequenceX -> Sequence", "add num_cycles", "remove foo"
  Edit edit;            ///< of the document
  std::string port;     ///< whose field the user goes on with; empty: none
  std::string command;  ///< ID of one that is run at the node, in the place of the edit; or empty
  bool makes_format_4 = false;  ///< of the whole file, in the place of the edit
};

/// The fixes for what a checker says about this document: the nearest right name in the place of a
/// wrong one, a port that is missing, an attribute that nobody knows, types without a model. Often
/// there is none.
std::vector<Fix> FixesFor(const Document& document, const Diagnostic& problem);

/// The byte at that line and column, or the size of the text.
std::uint32_t OffsetOf(const Document& document, const SourceLocation& where);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_FIXES_H_

// What tinyxml2 accepts though the XML standard does not: running robots have such files, so they
// are read, with a warning; other tools will refuse them. Each kind can be mended without changing
// what the file means to this engine.
//
//   _while="a == 3 && b"      write &amp;&amp;
//   value="<;0.5"             write &lt;
//   <!-- ---- title ---- -->  two dashes must not stand in a comment
//   blank line before <?xml?> it must come first
//   a="1"b="2"                attributes need a blank between them
//   < Sequence>, </S x="1">   a tag begins with its name; an end tag has nothing else
//   </S> behind the root      what follows is not read (nor behind a zero byte); cannot be mended
//   bytes that are no UTF-8   cannot be mended: nobody knows what was meant
#ifndef COPPICE_BT_CORE_MODEL_STRICTNESS_H_
#define COPPICE_BT_CORE_MODEL_STRICTNESS_H_

#include "bt_core/model/document.h"

namespace coppice {

/// One warning for each kind of thing that a strict parser refuses, at the first one, with their
/// number.
void WarnOfLaxXml(const Document& document, Diagnostics& diagnostics);

/// What makes the text strict XML without changing its meaning. Empty if it is strict.
Edit StrictXmlEdit(const Document& document);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_STRICTNESS_H_

// Why a text is not XML, said so that a person can mend it: tinyxml2 knows the line of the element
// only, and that of the wrong one where an end tag is missing.
#ifndef COPPICE_BT_CORE_MODEL_XML_ERROR_H_
#define COPPICE_BT_CORE_MODEL_XML_ERROR_H_

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace coppice {

struct XmlError {
  std::size_t offset = 0;
  std::string message;
  std::string hint;
};

/// The first mistake in the text, or nothing if none is found: then the text may still be no
/// document, for example an empty one.
std::optional<XmlError> FindXmlError(std::string_view text);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_XML_ERROR_H_

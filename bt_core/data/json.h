// JSON of values: for the live view, for tools, and for literals of structs in XML.
//
// A struct names its fields once and gets its text form, which is JSON behind "json:":
//
//   struct Pose { double x = 0; double y = 0; };
//   template <> struct coppice::ValueTraits<Pose> : coppice::JsonTraits<Pose> {
//     static constexpr const char* kName = "Pose";
//     template <class Fields, class P>
//     static void List(Fields& fields, P& pose) { fields("x", pose.x)("y", pose.y); }
//   };
//
//   <DriveTo goal='json:{"x":1.5,"y":-2}'/>
//
// A type with a text form of its own takes ToJson and FromJson from JsonTraits and nothing else:
//
//   static std::string ToJson(const Pose& pose) { return coppice::JsonTraits<Pose>::ToJson(pose); }
#ifndef COPPICE_BT_CORE_DATA_JSON_H_
#define COPPICE_BT_CORE_DATA_JSON_H_

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/data/type.h"

namespace coppice {

/// Writes an object, field by field.
class JsonWriter {
 public:
  template <class T>
  JsonWriter& operator()(std::string_view name, const T& value) {
    Add(name, TypeOf<T>().to_json(&value));
    return *this;
  }
  std::string text() const { return text_.empty() ? "{}" : text_ + "}"; }

 private:
  void Add(std::string_view name, const std::string& json);

  std::string text_;
};

/// Reads an object, field by field. Every field must be there, and none may be left over but
/// "__type", which other tools add.
class JsonReader {
 public:
  explicit JsonReader(std::string_view json);

  template <class T>
  JsonReader& operator()(std::string_view name, T& value) {
    const std::string* const json = Take(name);
    good_ = json && TypeOf<T>().from_json(*json, &value) && good_;
    return *this;
  }

  /// After the last field: false if anything was wrong.
  bool good() const { return good_ && taken_ == fields_.size(); }

 private:
  const std::string* Take(std::string_view name);

  std::vector<std::pair<std::string, std::string>> fields_;  // name and JSON
  std::size_t taken_ = 0;
  bool good_ = true;
};

/// The texts of a JSON array's elements; false if it is none.
bool SplitJsonArray(std::string_view json, std::vector<std::string>& elements);

template <class T>
struct JsonTraits {
  static std::string ToJson(const T& value) {
    JsonWriter writer;
    ValueTraits<T>::List(writer, value);
    return writer.text();
  }
  static bool FromJson(std::string_view json, T& out) {
    JsonReader reader(json);
    ValueTraits<T>::List(reader, out);
    return reader.good();
  }
  static bool Parse(std::string_view text, T& out) {
    constexpr std::string_view kPrefix = "json:";
    const bool has_prefix = text.substr(0, kPrefix.size()) == kPrefix;
    return has_prefix && FromJson(text.substr(kPrefix.size()), out);
  }
  static std::string Print(const T& value) { return "json:" + ToJson(value); }
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_JSON_H_

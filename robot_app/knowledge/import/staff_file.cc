#include <algorithm>
#include <sstream>

#include "bt_core/base/read_file.h"
#include "robot_app/knowledge/import/csv_table.h"
#include "robot_app/knowledge/import/site_files.h"
#include "robot_app/knowledge/store/folded_text.h"

namespace coppice::robot::knowledge {
namespace {

enum Column {
  kGiven,
  kFamily,
  kTitle,
  kOffice,
  kPhone,
  kEmail,
  kFunctionEn,
  kFunctionDe,
  kAlso,
  kId
};

const CsvFormat kFormat = {{{"given_name", true},
                            {"family_name", true},
                            {"title"},
                            {"office"},
                            {"phone"},
                            {"email"},
                            {"function_en"},
                            {"function_de"},
                            {"also"},
                            {"id"}}};

std::string Joined(const std::vector<std::string>& parts, char by) {
  std::string joined;
  for (const std::string& part : parts) {
    if (part.empty()) continue;
    joined += (joined.empty() ? "" : std::string(1, by)) + part;
  }
  return joined;
}

class Reader {
 public:
  Reader(Campus& campus, SiteIds& ids, Diagnostics& diagnostics)
      : campus_(campus), ids_(ids), diagnostics_(diagnostics) {}

  void Read(const CsvRow& row) {
    const auto& fields = row.fields;
    if (fields[kFamily].empty()) {
      diagnostics_.Error(row.where, "expected a family_name");
      return;
    }
    const std::string id = fields[kId].empty()
                               ? Joined(Words(fields[kGiven] + " " + fields[kFamily]), '_')
                               : fields[kId];
    if (!people_.Add({id, row.where}, diagnostics_)) return;
    if (!fields[kOffice].empty()) ids_.places.Expect({fields[kOffice], row.where}, diagnostics_);
    campus_.people.push_back({id, fields[kOffice], fields[kPhone], fields[kEmail]});
    AddNames(id, fields);
  }

 private:
  void AddNames(const std::string& id, const std::vector<std::string>& fields) {
    const std::string whole = Joined({fields[kGiven], fields[kFamily]}, ' ');
    for (const Language language : kLanguages) {
      const auto add = [&](const std::string& text, bool is_main) {
        if (!text.empty()) campus_.names.push_back({Kind::kPerson, id, language, text, is_main});
      };
      add(Joined({fields[kTitle], whole}, ' '), true);
      add(whole, false);
      add(fields[kFamily], false);
      add(fields[language == Language::kEnglish ? kFunctionEn : kFunctionDe], false);
      std::istringstream also(fields[kAlso]);
      for (std::string other; std::getline(also, other, ';');) add(other, false);
    }
  }

  Campus& campus_;
  SiteIds& ids_;
  Diagnostics& diagnostics_;
  Ids people_{"person"};
};

}  // namespace

void ReadStaff(const std::string& path, Campus& campus, SiteIds& ids, Diagnostics& diagnostics) {
  const auto text = coppice::ReadFile(path, diagnostics);
  if (!text) return;
  Reader reader(campus, ids, diagnostics);
  ReadCsv(path, BytesOf(*text), kFormat, diagnostics, [&](CsvRow& row) { reader.Read(row); });
}

}  // namespace coppice::robot::knowledge

# cmake -DFOLDER=... -DNAMESPACE=... -DOUT=... -P texts.cmake: the files of a folder as a C++ table, with
#   std::string_view NAMESPACE::text_file(std::string_view name);         the text, "" if there is none
#   std::vector<std::string_view> NAMESPACE::text_files();                all names, as "folder/name"
file(GLOB_RECURSE names RELATIVE ${FOLDER} ${FOLDER}/*)
list(SORT names)
file(WRITE ${OUT}.new "#include <algorithm>\n#include <string_view>\n#include <vector>\n\nnamespace ${NAMESPACE} {\nnamespace {\n
struct TextFile {\n  std::string_view name, text;\n};\nconstexpr TextFile all_text_files[] = {\n")
foreach(name ${names})
  file(READ ${FOLDER}/${name} text)
  file(APPEND ${OUT}.new "{\"${name}\", R\"_text_(")
  file(APPEND ${OUT}.new "${text}")
  file(APPEND ${OUT}.new ")_text_\"},\n")
endforeach()
file(APPEND ${OUT}.new "};\n\n} // namespace\n
std::string_view text_file(std::string_view name);
std::string_view text_file(std::string_view name) {
  const auto* const found = std::ranges::find(all_text_files, name, &TextFile::name);
  return found == std::end(all_text_files) ? std::string_view() : found->text;
}\n
std::vector<std::string_view> text_files();
std::vector<std::string_view> text_files() {
  std::vector<std::string_view> names;
  for (const TextFile& file : all_text_files)
    names.push_back(file.name);
  return names;
}\n
} // namespace ${NAMESPACE}\n")
file(RENAME ${OUT}.new ${OUT})

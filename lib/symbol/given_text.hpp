#pragma once
// Texts that stand for files: a formula of the command line, standard input.

#include <functional>
#include <string>

namespace kov {

/// From now on read_text and read_document take `text` for what the file `name` has.  Child processes
/// that are made later know it, too.
void give_text(const std::string& name, std::string text);
/// A text that was given, or standard input: there is no such file to read again.
[[nodiscard]] bool is_given(const std::string& name);
/// "cases/" of cases/top.toml; "" of a text that was given.
[[nodiscard]] std::string folder_of(const std::string& name);
/// The name itself; "-": standard input is read, for the child processes, which have none.
const std::string& for_children(const std::string& name);

/// Who is told of formulas of files that were read in another way than they stand: "range: 0.1 read as 1/10".
void tell_readings(std::function<void(const std::string&)> tell);

} // namespace kov

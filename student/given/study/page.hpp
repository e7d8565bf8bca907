// Given: the page around charts.
#pragma once

#include <filesystem>
#include <string>

namespace bounce::study {

// & and < as HTML writes them.
std::string escaped(const std::string& text);

// HTML. `note` stands above the body, with a bar beside it; "" if there is none.
std::string page(const std::string& title, const std::string& note, const std::string& body);

// Throws std::runtime_error, naming the file, where that can't be done.
void write_page(const std::filesystem::path& file, const std::string& html);

}  // namespace bounce::study

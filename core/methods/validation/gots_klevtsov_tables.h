#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

/// [gots-klevtsov], Tables 2 and 3 as printed (with a decimal point), in N·m.
namespace ravnoves::methods::gots_klevtsov {

inline constexpr double table_2_step = 15.0;  ///< °, of its rows from 0° to 720°
inline constexpr double table_3_step = 30.0;  ///< °, of its rows (0…720°) and columns (0…330°)

/// A printed number with the other sign: "-90" of "90".
inline std::string opposite(std::string_view printed) {
    return printed == "0"             ? "0"
           : printed.starts_with("-") ? std::string(printed.substr(1))
                                      : "-" + std::string(printed);
}

/// M_up; M_id is printed as its opposite.
inline constexpr std::array<std::string_view, 49> table_2{
    "0",    "90",   "140",  "130",  "72",    "-5",   "-67",  "-97",  "-96",  "-76",
    "-49",  "-24",  "0",    "0.73", "0.154", "79",   "106",  "122",  "96",   "80",
    "28",   "44",   "155",  "315",  "0",     "-893", "-798", "-503", "-360", "-290",
    "-261", "-227", "-188", "-135", "-82",   "-37",  "0",    "-30",  "57",   "97",
    "111",  "129",  "88",   "29",   "56",    "122",  "126",  "88",   "0"};

inline constexpr std::size_t table_3_columns = 12;
inline constexpr std::size_t table_3_rows = 25;
/// M_s; the last column, of α = 330°, is headed M_up. Rows of the first half turn: the
/// others print the opposite and the same in turn.
inline constexpr std::array<std::array<std::string_view, table_3_columns>, 6> table_3_half{{
    {"0", "215.2", "372.72", "430.39", "372.72", "215.2", "0", "-215.2", "-372.72", "-430.39",
     "-372.72", "-215.2"},
    {"215.2", "372.73", "430.38", "372.73", "215.19", "0", "-215.2", "-372.73", "-430.38",
     "-372.73", "-215.19", "-0.01"},
    {"372.73", "430.38", "372.73", "215.2", "0", "-215.19", "-372.73", "-430.38", "-372.73",
     "-215.2", "0.01", "215.19"},
    {"430.39", "372.72", "215.2", "0", "-215.2", "-372.72", "-430.39", "-372.72", "-215.2", "0",
     "215.2", "372.72"},
    {"372.73", "215.19", "0", "-215.2", "-372.73", "-430.38", "-372.73", "-215.19", "-0.01",
     "215.2", "372.73", "430.38"},
    {"215.2", "0", "-215.19", "-372.73", "-430.38", "-372.73", "-215.2", "0.01", "215.19", "372.73",
     "430.38", "372.73"},
}};
inline std::string table_3(std::size_t row, std::size_t column) {
    const std::size_t rows = table_3_half.size();
    const std::string_view printed = table_3_half[row % rows][column];
    return row / rows % 2 == 0 ? std::string(printed) : opposite(printed);
}
/// The row "mean value": M_sm, and the mean of M_up under the last column.
inline constexpr std::array<std::string_view, table_3_columns> table_3_means{
    "0", "8.61",  "14.91",  "17.22",  "14.91",  "8.61",
    "0", "-8.61", "-14.91", "-17.22", "-14.91", "-37.9"};

}  // namespace ravnoves::methods::gots_klevtsov

// Writes the files of a report.
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include <passgraph/core/json.hpp>
#include <passgraph/image/image_file.hpp>

#include "tool/accuracy/report/chart.hpp"
#include "tool/accuracy/report/report.hpp"

namespace passgraph::accuracy {
namespace {

namespace fs = std::filesystem;

constexpr double kChartScale = 2.0; ///< pixels per unit: sharp on fine screens

Result<void> unwritable(const std::string& path)
{
    return fail({.code = "file_unwritable",
                 .message = fmt::format("`{}` cannot be written", path),
                 .hint = "is there room, and may you write to it?"});
}

/// Beside the file first, so that a reader never sees half of it.
Result<void> write_text(const fs::path& path, const std::string& text)
{
    const fs::path partial = path.string() + fmt::format(".{}.partial", ::getpid());
    {
        std::ofstream file(partial, std::ios::binary);
        file << text;
        file.close();
        if (file.fail())
            return unwritable(path.string());
    }
    std::error_code failed;
    fs::rename(partial, path, failed);
    return failed ? unwritable(path.string()) : Result<void>();
}

std::string base64(const std::string& bytes)
{
    static constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? kLetters[(group >> (18 - 6 * k)) & 63u] : '=';
    }
    return text;
}

} // namespace

std::string data_uri(const Picture& picture)
{
    // The encoder writes files alone: by way of one.
    const fs::path file = fs::temp_directory_path() / fmt::format("passgraph-{}.png", ::getpid());
    std::string uri;
    if (write_picture(file.string(), picture))
        if (const Result<std::string> bytes = read_text_file(file.string()))
            uri = "data:image/png;base64," + base64(*bytes);
    std::error_code ignored;
    fs::remove(file, ignored);
    return uri;
}

Result<void> write_report(const std::string& folder, const Measurements& measurements, const Conditions& conditions)
{
    const fs::path out(folder);
    std::error_code failed;
    fs::create_directories(out / "charts", failed);
    if (failed)
        return unwritable((out / "charts").string());
    Errors errors;
    const auto keep = [&](const Result<void>& done) {
        if (!done)
            append(errors, done.error());
    };
    keep(write_text(out / "accuracy.json", report_json(measurements, conditions)));
    keep(write_text(out / "accuracy.csv", report_csv(measurements)));
    for (const MeasuredLadder& ladder : measurements.ladders) {
        const Drawing chart = pareto_chart(ladder);
        keep(write_text(out / "charts" / (ladder.ladder->name + ".svg"), to_svg(chart)));
        keep(write_picture((out / "charts" / (ladder.ladder->name + ".png")).string(), to_picture(chart, kChartScale)));
    }
    keep(write_text(out / "index.html", report_html(measurements, conditions)));
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

} // namespace passgraph::accuracy

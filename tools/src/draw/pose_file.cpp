// SPDX-License-Identifier: MIT
#include "draw/pose_file.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include "lumi/baker/file_guard.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

using Vec = std::array<double, 3>;

constexpr double kRigidTolerance = 1e-3;  // error of a product of two axes: the numbers have four digits
constexpr std::streamsize kMostBytes = 1 << 16;
constexpr const char* kWanted = "give 16 numbers, row by row: right, up, back and eye as columns, then 0 0 0 1";

double dot(const Vec& a, const Vec& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec cross(const Vec& a, const Vec& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec scaled(const Vec& a, double by)
{
    return {a[0] * by, a[1] * by, a[2] * by};
}

Vec minus(const Vec& a, const Vec& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vec unit(const Vec& a)
{
    return scaled(a, 1 / std::sqrt(dot(a, a)));
}

Vec column(const Matrix4& m, size_t k)
{
    return {m[k], m[4 + k], m[8 + k]};
}

Vec3q30 q30(const Vec& a)
{
    const auto fixed = [](double v) { return static_cast<int32_t>(std::lround(v * kOneQ30)); };
    return {fixed(a[0]), fixed(a[1]), fixed(a[2])};
}

std::string without_separators(std::string line)
{
    for (char& c : line)
        if (c == ',' || c == ';' || c == '[' || c == ']' || c == '\r') c = ' ';
    return line;
}

double number_of(const std::string& word, const std::string& path, int line)
{
    size_t used = 0;
    double value = 0;
    try {
        value = std::stod(word, &used);
    } catch (const std::exception&) {
        used = 0;
    }
    if (used == word.size() && std::isfinite(value)) return value;
    throw Failure(path, "line " + std::to_string(line) + ": \"" + word + "\" is no number", kWanted);
}

void require(bool good, const std::string& path, const std::string& problem, const std::string& mend)
{
    if (!good) throw Failure(path, problem, mend);
}

}  // namespace

Matrix4 read_matrix(const std::string& path)
{
    baker::note_input(path);
    const LeaveAtOnce reading;
    std::ifstream file(path);
    require(file.good(), path, "cannot be read", kWanted);
    std::string text(kMostBytes, '\0');  // a device may have no end
    text.resize(static_cast<size_t>(file.read(text.data(), kMostBytes).gcount()));
    require(text.size() < kMostBytes, path, "is longer than any 16 numbers", kWanted);
    Matrix4 matrix{};
    size_t count = 0;
    std::istringstream lines(text);
    std::string line, word;
    for (int number = 1; std::getline(lines, line) && count <= matrix.size(); ++number)
        for (std::istringstream words(without_separators(line)); words >> word; ++count) {
            const double value = number_of(word, path, number);
            if (count < matrix.size()) matrix[count] = value;
        }
    require(count == matrix.size(), path,
            "holds " + (count < matrix.size() ? std::to_string(count) : "more than 16") + " numbers", kWanted);
    return matrix;
}

Pose pose_of(const Matrix4& m, const std::string& path)
{
    const auto near = [](double a, double b) { return std::abs(a - b) <= kRigidTolerance; };
    require(near(m[12], 0) && near(m[13], 0) && near(m[14], 0) && near(m[15], 1), path, "the last row is not 0 0 0 1",
            "write the matrix row by row; transpose it if it was written by columns");
    const Vec right = column(m, 0), up = column(m, 1), back = column(m, 2), eye = column(m, 3);
    for (const Vec& axis : {right, up, back})
        require(near(dot(axis, axis), 1), path, "the matrix is not rigid: an axis is not 1 long", "take its scale out");
    require(near(dot(right, up), 0) && near(dot(up, back), 0) && near(dot(back, right), 0), path,
            "the matrix is not rigid: its axes are not at right angles", "take its shear out");
    require(dot(cross(right, up), back) > 0, path, "the matrix mirrors", "negate one of its first three columns");
    constexpr double kFarthest = 2047;
    for (const double at : eye)
        require(std::abs(at) <= kFarthest, path, "the eye is more than 2047 radii away",
                "give its place in radii of the sphere");
    const Vec out = unit(back), aside = unit(minus(right, scaled(out, dot(right, out))));
    const auto q20 = [](double v) { return static_cast<int32_t>(std::lround(v * kOneQ20)); };
    return {{q20(eye[0]), q20(eye[1]), q20(eye[2])}, q30(aside), q30(cross(out, aside)), q30(scaled(out, -1))};
}

}  // namespace lumi::tools

// SPDX-License-Identifier: MIT
// How fast a surface field is drawn by the board that runs this, as a line of JSON for each mode. Nothing is sent to a
// display. It is the same file for every board: a program gives it a clock and a place to write.
//
//     using Panel = lumi::Screen<240, 240, 16>;
//     static product_view<Panel> view;
//     measure::surface<Panel>({"my board", 133, now_us, print}, {"product", product, product_size()}, view);
//
// Each line is the mean and the worst of kViews frames all around, at 20 degrees and 3 radii.
#pragma once

#include <lumi/surface/view.h>

namespace measure
{

struct Board {
    const char* name;
    uint32_t clock_mhz;
    uint32_t (*now_us)();  // may begin anew after 2^32
    void (*print)(const char* text);
};

struct FieldBytes {
    const char* name;
    const uint8_t* bytes;
    size_t size;
};

constexpr uint32_t kViews = 24;

// Prints members of a JSON object. Names hold nothing that JSON wants escaped.
class Line
{
public:
    explicit Line(const Board& board) : board_(board) { board_.print("{"); }

    void text(const char* key, const char* value)
    {
        begin(key);
        board_.print("\"");
        board_.print(value);
        board_.print("\"");
    }
    void number(const char* key, uint64_t value)
    {
        begin(key);
        digits(value, 1);
    }
    void hundredths(const char* key, uint64_t value)
    {
        begin(key);
        digits(value / 100, 1);
        board_.print(".");
        digits(value % 100, 2);
    }
    void end() { board_.print("}\n"); }

private:
    void begin(const char* key)
    {
        board_.print(is_first_ ? "\"" : ", \"");
        board_.print(key);
        board_.print("\": ");
        is_first_ = false;
    }
    void digits(uint64_t value, int least)
    {
        char text[21] = {};
        char* at = text + 20;
        for (; value > 0 || least > 0; value /= 10, --least) *--at = static_cast<char>('0' + value % 10);
        board_.print(at);
    }

    const Board& board_;
    bool is_first_ = true;
};

struct Times {
    uint64_t sum_us = 0, worst_us = 0;
};

template <class Screen, class View>
lumi::ViewError draw_frame(View& view, uint32_t azimuth_turns32, lumi::SurfaceMode mode)
{
    alignas(4) static uint8_t pixels[Screen::kStripeBytes];
    const uint32_t stride = Screen::kStripeBytes / static_cast<uint32_t>(Screen::kRowsPx);
    lumi::ViewError error = view.look(lumi::Orbit{azimuth_turns32, lumi::degrees(20), lumi::radii(3)}, mode);
    for (int32_t y = 0; y < Screen::kHeightPx && error == lumi::ViewError::none; y += Screen::kRowsPx)
        error = view.draw({pixels, 0, y, Screen::kWidthPx, Screen::kRowsPx, stride});
    return error;
}

template <class Screen, class View>
lumi::ViewError time_views(const Board& board, View& view, lumi::SurfaceMode mode, Times& times)
{
    for (uint32_t k = 0; k < kViews; ++k) {
        const uint32_t begin = board.now_us();
        const lumi::ViewError error = draw_frame<Screen>(view, k * lumi::degrees(360 / kViews), mode);
        if (error != lumi::ViewError::none) return error;
        const uint32_t took = board.now_us() - begin;
        times.sum_us += took;
        if (took > times.worst_us) times.worst_us = took;
    }
    return lumi::ViewError::none;
}

template <class Screen>
void print_line(const Board& board, const FieldBytes& field, lumi::SurfaceMode mode, const Times& times)
{
    constexpr const char* kNames[] = {"one-sample", "antialiased", "2x2"};
    constexpr uint64_t kPixels = uint64_t{Screen::kWidthPx} * Screen::kHeightPx * kViews;
    const uint64_t sum_us = times.sum_us > 0 ? times.sum_us : 1;
    Line line(board);
    line.text("board", board.name);
    line.number("clock_mhz", board.clock_mhz);
    line.text("field", field.name);
    line.number("bytes", field.size);
    line.text("mode", kNames[static_cast<uint8_t>(mode)]);
    line.number("width", Screen::kWidthPx);
    line.number("height", Screen::kHeightPx);
    line.number("rows", Screen::kRowsPx);
    line.hundredths("frames_a_second", kViews * uint64_t{100000000} / sum_us);
    line.number("worst_us", times.worst_us);
    line.hundredths("cycles_a_pixel", sum_us * board.clock_mhz * 100 / kPixels);
    line.end();
}

// A line for each mode that the view has memory for, or one that says why there is none.
template <class Screen, class View>
void surface(const Board& board, const FieldBytes& field, View& view)
{
    constexpr lumi::SurfaceMode kModes[] = {lumi::SurfaceMode::one_sample, lumi::SurfaceMode::antialiased,
                                            lumi::SurfaceMode::two_by_two};
    lumi::ViewError error = view.open(field.bytes, field.size);
    for (const lumi::SurfaceMode mode : kModes) {
        Times times;
        if (error == lumi::ViewError::none) error = time_views<Screen>(board, view, mode, times);
        if (error == lumi::ViewError::mode_too_fine) return;
        if (error != lumi::ViewError::none) break;
        print_line<Screen>(board, field, mode, times);
    }
    if (error == lumi::ViewError::none) return;
    Line line(board);
    line.text("error", lumi::error_text(error));
    line.end();
}

}  // namespace measure

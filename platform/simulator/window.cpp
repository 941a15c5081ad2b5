// SPDX-License-Identifier: MIT
#include "simulator.h"

#include <SDL.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace simulator
{
namespace
{

constexpr int kDoubledPx = 320;  // smaller displays are shown twice as large
constexpr uint32_t kLeastZoom = lumi::kNoZoom / 4, kMostZoom = 16 * lumi::kNoZoom;

SDL_Renderer* renderer;
SDL_Texture* texture;

[[noreturn]] void fail(const char* what)
{
    std::fprintf(stderr, "lumi_simulator: %s: %s\n", what, SDL_GetError());
    std::exit(1);
}

// A degree a pixel; the object follows the mouse.
void turn(lumi::Orbit& orbit, int x_px, int y_px)
{
    orbit.azimuth_turns32 -= lumi::degrees(x_px);
    const int32_t limit = static_cast<int32_t>(lumi::degrees(89));
    const int64_t elevation = static_cast<int64_t>(static_cast<int32_t>(orbit.elevation_turns32)) +
                              static_cast<int32_t>(lumi::degrees(std::clamp(y_px, -179, 179)));
    orbit.elevation_turns32 = static_cast<uint32_t>(std::clamp<int64_t>(elevation, -limit, limit));
}

void zoom(lumi::Orbit& orbit, int steps)
{
    const int64_t zoom_q16 = orbit.zoom_q16 + int64_t{orbit.zoom_q16} * std::clamp(steps, -4, 4) / 8;
    orbit.zoom_q16 = static_cast<uint32_t>(std::clamp<int64_t>(zoom_q16, kLeastZoom, kMostZoom));
}

}  // namespace

void open_window()
{
    if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no display");
    const int scale = std::max(kWidthPx, kHeightPx) <= kDoubledPx ? 2 : 1;
    SDL_Window* window = SDL_CreateWindow("LumiPath", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, scale * kWidthPx,
                                          scale * kHeightPx, 0);
    if (window == nullptr) fail("no window");
    renderer = SDL_CreateRenderer(window, -1, 0);
    if (renderer == nullptr) fail("no renderer");
    texture = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_RGB565, SDL_TEXTUREACCESS_STREAMING, kWidthPx, kHeightPx);
    if (texture == nullptr) fail("no texture");
}

void show(const uint16_t* pixels)
{
    SDL_UpdateTexture(texture, nullptr, pixels, kWidthPx * static_cast<int>(sizeof(*pixels)));
    SDL_RenderCopy(renderer, texture, nullptr, nullptr);
    SDL_RenderPresent(renderer);
}

bool wait_for_turn(lumi::Orbit& orbit, int most_ms)
{
    SDL_Event event;
    bool is_turned = false;
    const uint32_t begin_ms = SDL_GetTicks();
    while (!is_turned) {
        const int left_ms = most_ms < 0 ? -1 : std::max(0, most_ms - static_cast<int>(SDL_GetTicks() - begin_ms));
        if (SDL_WaitEventTimeout(&event, left_ms) == 0) return most_ms >= 0;
        do {  // all that have come
            if (event.type == SDL_QUIT) return false;
            if (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_ESCAPE) return false;
            if (event.type == SDL_MOUSEMOTION && (event.motion.state & SDL_BUTTON_LMASK) != 0) {
                turn(orbit, event.motion.xrel, event.motion.yrel);
                is_turned = true;
            }
            if (event.type == SDL_MOUSEWHEEL) {
                zoom(orbit, event.wheel.y);
                is_turned = true;
            }
            if (event.type == SDL_WINDOWEVENT) is_turned = true;  // uncovered, perhaps
        } while (SDL_PollEvent(&event) != 0);
    }
    return is_turned;
}

void drag(int x_px, int y_px)
{
    SDL_PumpEvents();
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    SDL_Event event = {};
    event.type = SDL_MOUSEMOTION;
    event.motion.state = SDL_BUTTON_LMASK;
    event.motion.xrel = x_px;
    event.motion.yrel = y_px;
    SDL_PushEvent(&event);
}

void wait_milliseconds(uint32_t count)
{
    SDL_Delay(count);
}

uint32_t milliseconds()
{
    return SDL_GetTicks();
}

}  // namespace simulator

// Turns the desk clock on a display, by the library LovyanGFX: while DMA sends a stripe, the processor draws the next one.
// LovyanGFX finds the displays of many boards by itself. For another one put a class LGFX into this folder, as its
// example 2_user_setting does, and include that in place of the first two lines.
#define LGFX_AUTODETECT
#include <LovyanGFX.hpp>
#include <Lumi.h>
#include <lumi_fields/desk_clock.h>

using lumi::Orbit;
using lumi::ViewError;

static LGFX lcd;
static desk_clock_view<lumi::Screen<240, 240, 8>> view;  // the memory of a frame: 240 x 240 pixels, 8 rows at once
alignas(4) static uint8_t stripes[2][240 * 8 * 2];
static int current;  // lives longer than a frame, whose last stripe is still sent when the next frame begins

static ViewError draw_frame(const Orbit& orbit)
{
  ViewError error = view.look(orbit);
  for (int y = 0; y < 240 && error == ViewError::none; y += 8, current ^= 1) {
    error = view.draw({stripes[current], 0, y, 240, 8, 240 * 2});
    lcd.waitDMA();  // until the other stripe has been sent
    lcd.pushImageDMA(0, y, 240, 8, reinterpret_cast<const lgfx::swap565_t*>(stripes[current]));
  }
  return error;
}

void setup()
{
  Serial.begin(115200);
  lcd.init();
  lcd.initDMA();
  lcd.fillScreen(0);
  lcd.startWrite();  // keeps the bus between stripes
  Serial.println(lumi::error_text(view.open(desk_clock, desk_clock_size())));
}

void loop()
{
  static Orbit orbit = {lumi::degrees(30), lumi::degrees(20), lumi::radii(3)};
  const ViewError error = draw_frame(orbit);
  if (error != ViewError::none) Serial.println(lumi::error_text(error));
  orbit.azimuth_turns32 += lumi::degrees(2);
}

// Turns the desk clock on a display, by the library TFT_eSPI. Which display, and on which pins, says TFT_eSPI's
// User_Setup.h.
#include <Lumi.h>
#include <TFT_eSPI.h>
#include <lumi_fields/desk_clock.h>

using lumi::Orbit;
using lumi::ViewError;

static TFT_eSPI tft;
static desk_clock_view<lumi::Screen<240, 240, 8>> view;  // the memory of a frame: 240 x 240 pixels, 8 rows at once
static uint16_t stripe[240 * 8];                         // in the byte order of the panel

static ViewError draw_frame(const Orbit& orbit)
{
  ViewError error = view.look(orbit);
  for (int y = 0; y < 240 && error == ViewError::none; y += 8) {
    error = view.draw({reinterpret_cast<uint8_t*>(stripe), 0, y, 240, 8, 240 * 2});
    tft.pushImage(0, y, 240, 8, stripe);  // comes back when the display has the pixels
  }
  return error;
}

void setup()
{
  Serial.begin(115200);
  tft.init();
  tft.setSwapBytes(false);  // lumi has swapped them
  tft.fillScreen(TFT_BLACK);
  Serial.println(lumi::error_text(view.open(desk_clock, desk_clock_size())));
}

void loop()
{
  static Orbit orbit = {lumi::degrees(30), lumi::degrees(20), lumi::radii(3)};
  const ViewError error = draw_frame(orbit);
  if (error != ViewError::none) Serial.println(lumi::error_text(error));
  orbit.azimuth_turns32 += lumi::degrees(2);
}

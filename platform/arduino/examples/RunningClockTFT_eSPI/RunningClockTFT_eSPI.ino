// A desk clock that shows the time on a display, by the library TFT_eSPI. Which display, and on which pins, says
// TFT_eSPI's User_Setup.h. Each second the display is sent only what has changed.
#include <Lumi.h>
#include <TFT_eSPI.h>
#include <lumi_fields/running_clock.h>

using lumi::PixelRect;
using lumi::ViewError;

static TFT_eSPI tft;
static running_clock_view<lumi::Screen<240, 240, 8>> view;  // the memory of a frame: 240 x 240 pixels, 8 rows at once
static uint16_t stripe[240 * 8];                            // in the byte order of the panel

static ViewError turn(uint32_t hand, uint32_t seconds, uint32_t secondsATurn)
{
  const uint64_t turns = (static_cast<uint64_t>(seconds % secondsATurn) << 32) / secondsATurn;
  return view.turn(hand, static_cast<uint32_t>(turns));
}

static ViewError draw(const PixelRect& rect)
{
  const int32_t rows = view.rows_at(rect.width_px), end = rect.y_px + rect.height_px;
  ViewError error = ViewError::none;
  for (int32_t y = rect.y_px; y < end && error == ViewError::none; y += rows) {
    const int32_t height = end - y < rows ? end - y : rows;
    error = view.draw({reinterpret_cast<uint8_t*>(stripe), rect.x_px, y, rect.width_px, height,
                       static_cast<uint32_t>(rect.width_px) * 2});
    tft.pushImage(rect.x_px, y, rect.width_px, height, stripe);  // comes back when the display has the pixels
  }
  return error;
}

static ViewError show(uint32_t second)
{
  ViewError error = turn(running_clock_parts::second_hand, second, 60);
  if (error == ViewError::none) error = turn(running_clock_parts::minute_hand, second / 10 * 10, 3600);
  if (error == ViewError::none) error = turn(running_clock_parts::hour_hand, second / 60 * 60, 43200);
  if (error == ViewError::none) error = view.look(lumi::Orbit{lumi::degrees(15), lumi::degrees(10), lumi::radii(3)});
  const lumi::ChangedRects changed = view.changed();
  for (uint32_t k = 0; k < changed.count && error == ViewError::none; ++k) error = draw(changed.rect[k]);
  return error;
}

void setup()
{
  Serial.begin(115200);
  tft.init();
  tft.setSwapBytes(false);  // lumi has swapped them
  Serial.println(lumi::error_text(view.open(running_clock, running_clock_size())));
}

void loop()
{
  const uint32_t start = (10 * 60 + 8) * 60;  // take it from a clock that knows the time
  const ViewError error = show(start + millis() / 1000);
  if (error != ViewError::none) Serial.println(lumi::error_text(error));
  delay(1000 - millis() % 1000);
}

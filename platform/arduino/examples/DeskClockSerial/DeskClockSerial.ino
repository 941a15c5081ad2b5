// Draws the desk clock and says on the serial port how long a frame takes. No display is needed.
#include <Lumi.h>
#include <lumi_fields/desk_clock.h>

using lumi::Orbit;
using lumi::ViewError;

static desk_clock_view<lumi::Screen<240, 240, 8>> view;  // the memory of a frame: 240 x 240 pixels, 8 rows at once
alignas(4) static uint8_t stripe[240 * 8 * 2];

static ViewError draw_frame(const Orbit& orbit)
{
  ViewError error = view.look(orbit);
  for (int y = 0; y < 240 && error == ViewError::none; y += 8) error = view.draw({stripe, 0, y, 240, 8, 240 * 2});
  return error;
}

void setup()
{
  Serial.begin(115200);
  Serial.println(lumi::error_text(view.open(desk_clock, desk_clock_size())));
}

void loop()
{
  static Orbit orbit = {lumi::degrees(30), lumi::degrees(20), lumi::radii(3)};
  const unsigned long begin = micros();
  const ViewError error = draw_frame(orbit);
  Serial.print(micros() - begin);
  Serial.print(" microseconds a frame: ");
  Serial.println(lumi::error_text(error));
  orbit.azimuth_turns32 += lumi::degrees(2);
}

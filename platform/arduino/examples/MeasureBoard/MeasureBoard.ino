// Says on the serial port how fast this board draws the desk clock, as lines of JSON. No display is needed.
#include <Lumi.h>
#include <lumi_fields/desk_clock.h>
#include <lumi_measure.h>

using Panel = lumi::Screen<240, 240, 8>;
static desk_clock_view<Panel> view;

#ifdef F_CPU
static const uint32_t clock_mhz = F_CPU / 1000000;
#else
static const uint32_t clock_mhz = 0;  // write the clock of your board: cycles_a_pixel needs it
#endif

static uint32_t now_us() { return micros(); }
static void print(const char* text) { Serial.print(text); }

void setup()
{
  Serial.begin(115200);
}

void loop()
{
  measure::surface<Panel>({"Arduino", clock_mhz, now_us, print}, {"desk_clock", desk_clock, desk_clock_size()}, view);
  delay(5000);
}

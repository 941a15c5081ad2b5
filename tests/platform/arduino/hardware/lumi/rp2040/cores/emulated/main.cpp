// SPDX-License-Identifier: MIT
// Calls loop() twice, through semihosting. To wait moves the clock on.
#include <Arduino.h>
#include <stdio.h>
#include <time.h>

SerialPort Serial;

static unsigned long waited_ms;

unsigned long micros()
{
    return static_cast<unsigned long>(clock()) * (1000000 / CLOCKS_PER_SEC) + 1000 * waited_ms;
}

unsigned long millis()
{
    return micros() / 1000;
}

void delay(unsigned long milliseconds)
{
    waited_ms += milliseconds;
}

void SerialPort::begin(unsigned long) {}

void SerialPort::print(const char* text)
{
    fputs(text, stderr);
}

void SerialPort::print(unsigned long number)
{
    fprintf(stderr, "%lu", number);
}

void SerialPort::println(const char* text)
{
    fprintf(stderr, "%s\n", text);
}

__attribute__((weak)) void after_loop() {}

int main()
{
    setup();
    for (int frame = 0; frame < 2; ++frame) {
        loop();
        after_loop();
    }
    return 0;
}

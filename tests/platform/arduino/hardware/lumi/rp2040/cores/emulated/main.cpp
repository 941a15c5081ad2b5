// SPDX-License-Identifier: MIT
// Calls loop() twice, through semihosting.
#include <Arduino.h>
#include <stdio.h>
#include <time.h>

SerialPort Serial;

unsigned long micros()
{
    return static_cast<unsigned long>(clock()) * (1000000 / CLOCKS_PER_SEC);
}

unsigned long millis()
{
    return micros() / 1000;
}

void delay(unsigned long) {}

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

int main()
{
    setup();
    for (int frame = 0; frame < 2; ++frame) loop();
    return 0;
}

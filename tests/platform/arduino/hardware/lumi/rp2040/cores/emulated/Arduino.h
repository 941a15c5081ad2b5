// SPDX-License-Identifier: MIT
// Stands for as much of Arduino's core as sketches of lumi call, on an emulated board: the serial port is standard
// error.
#pragma once

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus

void setup();
void loop();
void after_loop();  // a library may have one
unsigned long micros();
unsigned long millis();
void delay(unsigned long milliseconds);

struct SerialPort {
    void begin(unsigned long baud);
    void print(const char* text);
    void print(unsigned long number);
    void println(const char* text);
};
extern SerialPort Serial;

#endif

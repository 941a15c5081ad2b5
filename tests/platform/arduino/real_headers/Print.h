// SPDX-License-Identifier: MIT
// Headers of display libraries ask this of Arduino's core beyond Arduino.h: names alone, to check a sketch's calls.
#pragma once

#include <Arduino.h>
#include <stddef.h>

class Print
{
public:
    virtual size_t write(uint8_t byte);
    virtual size_t write(const uint8_t* bytes, size_t count);
};

class String
{
public:
    String(const char* text = "");
    const char* c_str() const;
    size_t length() const;
};

enum { LOW, HIGH };
void digitalWrite(int pin, int level);
int digitalRead(int pin);
void delayMicroseconds(unsigned int microseconds);
void* memcpy_P(void* to, const void* from, size_t bytes);

// SPDX-License-Identifier: MIT
// run_gba PROGRAM.gba FOLDER FRAMES
// Runs a cartridge in mGBA, prints the lines of its debug log that say "frame ..." and writes what the display shows at
// each of them, FOLDER/frame-0.raw, ..., red, green and blue of 240 x 160 pixels. After the first frame it holds the
// keys right and up. Ends with the cartridge's "exit" code, or 1 after ten minutes of the console's time.
#include <mgba-util/vfs.h>
#include <mgba/core/blip_buf.h>
#include <mgba/core/core.h>
#include <mgba/core/log.h>
#include <mgba/flags.h>
#include <mgba/gba/core.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kWidth = 240, kHeight = 160, kKeyRight = 1 << 4, kKeyUp = 1 << 6, kMostVideoFrames = 36000 };

static color_t pixels[kWidth * kHeight];
static struct mCore* core;
static const char* folder;
static int frames_left, exit_code = -1;

static void take_picture(int frame)
{
    char path[4096];
    snprintf(path, sizeof(path), "%s/frame-%d.raw", folder, frame);
    FILE* file = fopen(path, "wb");
    if (file == NULL) {
        perror(path);
        exit(1);
    }
    for (int k = 0; k < kWidth * kHeight; ++k) {
        const color_t c = pixels[k];
        const unsigned char rgb[3] = {c & 255, c >> 8 & 255, c >> 16 & 255};
        fwrite(rgb, 1, sizeof(rgb), file);
    }
    fclose(file);
}

static void take_line(const char* line)
{
    int number;
    if (sscanf(line, "exit %d", &number) == 1) exit_code = number;
    if (sscanf(line, "frame %d", &number) != 1 || frames_left == 0) return;
    puts(line);
    take_picture(number);
    core->setKeys(core, kKeyRight | kKeyUp);
    if (--frames_left == 0) exit_code = 0;
}

static void log_line(struct mLogger* logger, int category, enum mLogLevel level, const char* format, va_list arguments)
{
    char line[1024];
    (void)logger, (void)category, (void)level;
    vsnprintf(line, sizeof(line), format, arguments);
    const char* words = strstr(line, "frame ");
    if (words == NULL) words = strstr(line, "exit ");
    if (words != NULL) take_line(words);
}

int main(int count, char** arguments)
{
    static struct mLogger logger = {.log = log_line};
    if (count != 4) {
        fprintf(stderr, "run_gba PROGRAM.gba FOLDER FRAMES\n");
        return 2;
    }
    folder = arguments[2];
    frames_left = atoi(arguments[3]);
    mLogSetDefaultLogger(&logger);
    core = GBACoreCreate();
    core->init(core);
    mCoreInitConfig(core, NULL);
    core->setVideoBuffer(core, pixels, kWidth);
    struct VFile* file = VFileOpen(arguments[1], O_RDONLY);
    if (file == NULL || !core->loadROM(core, file)) {
        fprintf(stderr, "%s: this is no cartridge\n", arguments[1]);
        return 1;
    }
    core->reset(core);
    for (int k = 0; k < kMostVideoFrames && exit_code < 0; ++k) core->runFrame(core);
    core->deinit(core);
    return exit_code < 0 ? 1 : exit_code;
}

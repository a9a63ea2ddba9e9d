#!/usr/bin/env python3
"""Makes the sounds of gesture-study.yaml: babble, syllables without meaning, said angrily or sadly.

    python3 babble.py FOLDER

writes angry-woman.wav, sad-woman.wav, angry-man.wav and sad-man.wav (16 kHz, one channel), the files beside it.

A voice is a train of glottal pulses through three resonators, the formants of a vowel (source-filter
synthesis, Fant 1960); each syllable begins with a burst of noise and has a falling pitch. Anger is fast, loud,
high and wide in pitch, sadness slow, soft, low and flat (directions: Scherer 2003). All numbers are our own
choice. These are stand-ins: a study needs recordings of people.
"""

import math
import pathlib
import struct
import sys
import wave

RATE = 16000

# First three formants in Hz of a man's vowels; a woman's are 1.16 times as high.
VOWELS = {"a": (750, 1150, 2500), "e": (480, 1850, 2550), "i": (290, 2250, 2950),
          "o": (460, 850, 2450), "u": (310, 760, 2300)}
BANDWIDTHS = (70, 90, 140)

# Syllables per second, mean pitch in Hz of a man, range of pitch in semitones, level, pause after four syllables.
MOODS = {"angry": (5.2, 150, 7.0, 0.85, 0.12), "sad": (2.9, 98, 2.0, 0.4, 0.3)}
SPEAKERS = {"man": (1.0, 1.0), "woman": (1.8, 1.16)}
SENTENCES = {"angry-woman": "aeaoiaueoaie", "sad-woman": "oauoaeou", "angry-man": "eaoaieuaoeia", "sad-man": "uoaeoauo"}
SECONDS = {"angry": 2.6, "sad": 4.2}


class Noise:
    """A linear congruential generator, so that every machine makes the same noise."""

    def __init__(self, seed):
        self.state = seed

    def next(self):
        self.state = (1664525 * self.state + 1013904223) % 2**32
        return self.state / 2**31 - 1.0


def resonated(signal, frequency, bandwidth):
    """A resonator of two poles with unit gain at 0 Hz."""
    r = math.exp(-math.pi * bandwidth / RATE)
    a = 2.0 * r * math.cos(2.0 * math.pi * frequency / RATE)
    b = -r * r
    gain = 1.0 - a - b
    out, before, last = [], 0.0, 0.0
    for value in signal:
        before, last = last, gain * value + a * last + b * before
        out.append(last)
    return out


def syllable(seconds, pitch, formants, noise):
    samples = int(seconds * RATE)
    source, phase = [], 0.0
    for i in range(samples):
        t = i / samples
        phase += pitch * 2.0 ** ((0.5 - t) / 6.0) / RATE  # falls by two semitones
        opening = phase % 1.0
        pulse = 3.0 * (opening / 0.6) ** 2 - 2.0 * (opening / 0.6) ** 3 if opening < 0.6 else 0.0
        voice = math.sin(math.pi * min(1.0, t / 0.15) / 2.0) * math.sin(math.pi * min(1.0, (1.0 - t) / 0.35) / 2.0)
        burst = math.exp(-i / (0.008 * RATE)) * 0.7
        source.append((pulse - 0.4) * voice + noise.next() * (burst + 0.012 * voice))
    for frequency, bandwidth in zip(formants, BANDWIDTHS):
        source = resonated(source, frequency, bandwidth)
    # Lips radiate the derivative.
    return [now - before for before, now in zip([0.0] + source, source)]


def speech(mood, speaker, vowels, seed):
    rate, pitch, semitones, level, pause = MOODS[mood]
    higher, smaller = SPEAKERS[speaker]
    noise, samples = Noise(seed), [0.0] * int(0.15 * RATE)
    for number, vowel in enumerate(vowels):
        stress = 1.0 if number % 4 == 0 else 0.4 if number % 2 == 0 else 0.0
        own = pitch * higher * 2.0 ** (semitones * (stress - 0.4) / 12.0)
        samples += syllable(1.0 / rate, own, [smaller * f for f in VOWELS[vowel]], noise)
        if number % 4 == 3:
            samples += [0.0] * int(pause * RATE)
    wanted = int(SECONDS[mood] * RATE)
    samples = (samples + [0.0] * wanted)[:wanted]
    fade = int(0.03 * RATE)
    for i in range(fade):
        samples[wanted - 1 - i] *= i / fade
    most = max(abs(value) for value in samples)
    return [level * value / most for value in samples]


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: babble.py FOLDER")
    for seed, (name, vowels) in enumerate(SENTENCES.items(), 1):
        samples = speech(*name.split("-"), vowels, seed)
        with wave.open(str(pathlib.Path(sys.argv[1]) / (name + ".wav")), "wb") as file:
            file.setnchannels(1)
            file.setsampwidth(2)
            file.setframerate(RATE)
            file.writeframes(b"".join(struct.pack("<h", round(32767.0 * value)) for value in samples))


main()

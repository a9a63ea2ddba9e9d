// Keys of a group of radio buttons.

/**
 * As long as none is chosen, pages focus the group and not a button, so that no key but digits and arrows chooses: an
 * arrow key the first or, backwards, the last, and from there the next, as browsers do it. A button that the participant
 * reached by Tab is chosen by Space. `choose` is told whether a digit chose.
 */
export function chooseByKeys(
  group: HTMLElement, inputs: HTMLInputElement[], choose: (input: HTMLInputElement, isDigit: boolean) => void): void {
  group.tabIndex = -1;
  const isForward = (key: string) =>
    key === "ArrowDown" || key === (getComputedStyle(inputs[0]!).direction === "rtl" ? "ArrowLeft" : "ArrowRight");
  group.addEventListener("keydown", (event) => {
    const { key } = event;
    const isArrow = event.target === group && /^Arrow(Left|Right|Up|Down)$/.test(key);
    const input = isArrow ? inputs.filter(({ disabled }) => !disabled).at(isForward(key) ? 0 : -1)
      : /^[1-9]$/.test(key) ? inputs[Number(key) - 1] : undefined;
    if (!input || input.disabled || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    input.focus();
    choose(input, !isArrow);
  });
}

/** Focuses the chosen button, or the group. */
export const focusChoice = (group: HTMLElement, inputs: HTMLInputElement[]): void =>
  (inputs.find(({ checked }) => checked) ?? group).focus();

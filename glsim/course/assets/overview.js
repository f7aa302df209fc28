// Sorts the table by a column, and shows the rows that contain a text and are in a state.
const form = document.querySelector("form");
const [search, state] = form.querySelectorAll("input, select");
const body = document.querySelector("tbody");
const rows = [...body.rows];
const texts = new Map(rows.map(row => [row, row.textContent.toLowerCase()]));
const heads = [...document.querySelectorAll("thead th")];
const order = new Intl.Collator(undefined, { numeric: true });

function filter() {
  const words = search.value.toLowerCase().trim();
  let count = 0;
  for (const row of rows) {
    const states = row.dataset.state.split(" ");
    row.hidden = !texts.get(row).includes(words) || (state.value !== "" && !states.includes(state.value));
    count += !row.hidden;
  }
  form.querySelector("output").textContent = count === rows.length ? "" : count + " of " + rows.length;
}

function value(row, column) {
  const cell = row.cells[column];
  return cell.dataset.value === undefined ? cell.querySelector("summary b").textContent : Number(cell.dataset.value);
}

function sort(column) {
  const up = heads[column].getAttribute("aria-sort") !== "ascending";
  heads.forEach(head => head.removeAttribute("aria-sort"));
  heads[column].setAttribute("aria-sort", up ? "ascending" : "descending");
  const compare = (a, b) => column ? value(a, column) - value(b, column) : order.compare(value(a, 0), value(b, 0));
  rows.sort((a, b) => up ? compare(a, b) : compare(b, a));
  body.append(...rows);
}

heads.forEach((head, column) => head.querySelector("button")?.addEventListener("click", () => sort(column)));
form.addEventListener("submit", event => event.preventDefault());
form.addEventListener("input", filter);
form.hidden = document.querySelector("thead").hidden = false;
filter();

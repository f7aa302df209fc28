if (!customElements.get("glsim-compare")) customElements.define("glsim-compare", class extends HTMLElement {});
